#pragma once
/// Products and substitutions with the dense columns of a supernodal factor. Such a column is read once per pass, so
/// its speed is that of the memory: eight columns are read side by side, and the vectors stay in the cache. Several
/// vectors take the same operations in the same order, whatever their number.
///
/// A panel is a column-major array L of rows x columns entries, `stride` apart from column to column. Machine
/// instructions are chosen when the program starts.

#include <cstddef>
#include <cstdint>

namespace creepcontact::linalg {

struct Panel {
  const double* entries;
  std::int64_t stride;
  std::int64_t n_rows, n_columns;
};

/// The number of vectors that the kernels take for so many: some of them may be of zeros.
constexpr std::size_t padded(std::size_t vectors) {
  return vectors == 1 ? 1 : (vectors + 3) / 4 * 4;
}

// The first n_columns rows of the panels of the next two are a lower triangle. `vectors` is a padded() number.

/// x1 = L11^-1 x1, then x2 -= L21 x1. @param x  n_rows rows (x1, x2) of `vectors` entries
void eliminate(const Panel& panel, double* x, std::size_t vectors = 1);
/// x1 = L11^-T (x1 - L21^T x2). @param x  n_rows rows (x1, x2) of `vectors` entries
void substitute(const Panel& panel, double* x, std::size_t vectors = 1);

/// to -= L from. @param from  n_columns rows of `vectors` entries @param to  n_rows rows
void subtract_product(const Panel& panel, const double* from, double* to, std::size_t vectors = 1);
/// to -= L^T from. @param from  n_rows rows of `vectors` entries @param to  n_columns rows
void subtract_transposed_product(const Panel& panel, const double* from, double* to, std::size_t vectors = 1);

}  // namespace creepcontact::linalg

#pragma once
/// Products and substitutions with the dense columns of a supernodal factor. Such a column is read once per pass, so
/// its speed is that of the memory: eight columns are read side by side, and the vectors stay in the cache.
///
/// A panel is a column-major array L of rows x columns entries, `stride` apart from column to column. Machine
/// instructions are chosen when the program starts.

#include <cstdint>

namespace creepcontact::linalg {

struct Panel {
  const double* entries;
  std::int64_t stride;
  std::int64_t n_rows, n_columns;
};

// The first n_columns rows of the panels of the next two are a lower triangle.

/// x1 = L11^-1 x1, then x2 -= L21 x1. @param x  n_rows entries (x1, x2)
void eliminate(const Panel& panel, double* x);
/// x1 = L11^-T (x1 - L21^T x2). @param x  n_rows entries (x1, x2)
void substitute(const Panel& panel, double* x);

/// to -= L from. @param from  n_columns entries @param to  n_rows entries
void subtract_product(const Panel& panel, const double* from, double* to);
/// to -= L^T from. @param from  n_rows entries @param to  n_columns entries
void subtract_transposed_product(const Panel& panel, const double* from, double* to);

}  // namespace creepcontact::linalg

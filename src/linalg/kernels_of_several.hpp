#pragma once
/// The kernels of panel_kernels.hpp for several vectors, a multiple of 4.

#include "panel_kernels.hpp"

namespace creepcontact::linalg {

void eliminate_several(const Panel& panel, double* x, std::size_t vectors);
void substitute_several(const Panel& panel, double* x, std::size_t vectors);
void subtract_product_of_several(const Panel& panel, const double* from, double* to, std::size_t vectors);
void subtract_transposed_product_of_several(const Panel& panel, const double* from, double* to, std::size_t vectors);

}  // namespace creepcontact::linalg

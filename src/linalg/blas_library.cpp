#include "creepcontact/linalg/blas_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace creepcontact::linalg {
namespace {

/// The file of a symbol as the loader resolves it for the libraries that call it.
std::string file_of(const char* symbol) {
  void* const address = ::dlsym(RTLD_DEFAULT, symbol);
  Dl_info found{};
  if (address == nullptr || ::dladdr(address, &found) == 0 || found.dli_fname == nullptr) return {};
  std::error_code failure;
  const std::filesystem::path real = std::filesystem::canonical(found.dli_fname, failure);
  return failure ? found.dli_fname : real.string();
}

bool contains(const std::string& file, std::string_view word) {
  return file.find(word) != std::string::npos;
}

}  // namespace

std::string why_slow_blas(const std::string& file) {
  constexpr std::array fast{"openblas", "mkl", "blis", "flexiblas", "libsci", "nvpl", "armpl"};
  if (file.empty() || std::ranges::any_of(fast, [&](const char* name) { return contains(file, name); })) return {};
  if (contains(file, "atlas") || contains(file, "f77blas"))
    return "ATLAS, which needs about twice the time of OpenBLAS";
  const std::string name = std::filesystem::path(file).filename().string();
  if (name.starts_with("libblas.so") || name.starts_with("liblapack.so"))
    return "the reference BLAS, which needs several times the time of OpenBLAS";
  return {};
}

BlasLibrary blas_library() {
  BlasLibrary found{file_of("dgemm_"), file_of("dpotrf_")};
  for (const std::string& file : {found.blas, found.lapack})
    if (const std::string why = why_slow_blas(file); found.warning.empty() && !why.empty())
      found.warning = fmt::format(
          "factorisations are slow: they use '{}', which is {}; install OpenBLAS (Debian package "
          "libopenblas0-pthread), "
          "and choose it where several are installed (update-alternatives --config libblas.so.3-x86_64-linux-gnu)",
          file, why);
  return found;
}

}  // namespace creepcontact::linalg

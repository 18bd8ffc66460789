#include "creepcontact/linalg/blas_library.hpp"

#include <gtest/gtest.h>

namespace creepcontact::linalg {
namespace {

TEST(BlasLibrary, OpenBlasServesThisProgram) {
  const BlasLibrary found = blas_library();
  EXPECT_NE(found.blas.find("openblas"), std::string::npos) << found.blas;
  EXPECT_NE(found.lapack.find("openblas"), std::string::npos) << found.lapack;
  EXPECT_EQ(found.warning, "");
}

TEST(BlasLibrary, SlowOnesAreKnownByTheirFiles) {
  for (const char* file : {"/usr/lib/x86_64-linux-gnu/atlas/libblas.so.3.10.3", "/usr/lib/libf77blas.so.3.10.3"})
    EXPECT_NE(why_slow_blas(file).find("ATLAS"), std::string::npos) << file;
  for (const char* file : {"/usr/lib/x86_64-linux-gnu/blas/libblas.so.3.11.0", "/usr/lib64/liblapack.so.3.11.0"})
    EXPECT_NE(why_slow_blas(file).find("reference"), std::string::npos) << file;
  for (const char* file :
       {"/usr/lib/x86_64-linux-gnu/openblas-pthread/libblas.so.3", "/usr/lib64/libopenblasp-r0.3.21.so",
        "/opt/intel/mkl/lib/libmkl_rt.so.2", "/usr/lib/x86_64-linux-gnu/blis-openmp/libblis.so.4", ""})
    EXPECT_EQ(why_slow_blas(file), "") << file;
}

}  // namespace
}  // namespace creepcontact::linalg

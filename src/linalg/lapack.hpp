#pragma once
/// The routines of BLAS and LAPACK that this module uses, with the lengths that Fortran adds for arguments of type
/// character. Matrices column by column. Source: Anderson and others, LAPACK Users' Guide (1999).

#include <cstddef>

// The names are those of the Fortran symbols.
// NOLINTBEGIN(readability-identifier-naming)
extern "C" {
/// Eigenvalues (ascending, w) and eigenvectors (a) of a symmetric matrix.
void dsyev_(const char* job, const char* triangle, const int* n, double* a, const int* stride, double* w, double* work,
            const int* n_work, int* info, std::size_t, std::size_t);
/// Eigenvalues and eigenvectors of A x = w B x (type 1), B positive definite.
void dsygv_(const int* type, const char* job, const char* triangle, const int* n, double* a, const int* stride_a,
            double* b, const int* stride_b, double* w, double* work, const int* n_work, int* info, std::size_t,
            std::size_t);
/// Singular values (descending, s) and vectors (u, vt).
void dgesvd_(const char* job_u, const char* job_vt, const int* m, const int* n, double* a, const int* stride, double* s,
             double* u, const int* stride_u, double* vt, const int* stride_vt, double* work, const int* n_work,
             int* info, std::size_t, std::size_t);
/// A = Q R by Householder reflections, and Q from these.
void dgeqrf_(const int* m, const int* n, double* a, const int* stride, double* tau, double* work, const int* n_work,
             int* info);
void dorgqr_(const int* m, const int* n, const int* k, double* a, const int* stride, const double* tau, double* work,
             const int* n_work, int* info);
/// A P = Q R, with P in pivots, counted from 1.
void dgeqp3_(const int* m, const int* n, double* a, const int* stride, int* pivots, double* tau, double* work,
             const int* n_work, int* info);
/// Least squares of least norm by a complete orthogonal factorisation.
void dgelsy_(const int* m, const int* n, const int* n_right, double* a, const int* stride_a, double* b,
             const int* stride_b, int* pivots, const double* threshold, int* rank, double* work, const int* n_work,
             int* info);
/// Solution of A X = B by LU factors.
void dgesv_(const int* n, const int* n_right, double* a, const int* stride_a, int* pivots, double* b,
            const int* stride_b, int* info);
/// Solution of A X = B by Cholesky factors, A positive definite.
void dposv_(const char* triangle, const int* n, const int* n_right, double* a, const int* stride_a, double* b,
            const int* stride_b, int* info, std::size_t);
/// B = op(A)^-1 B or B op(A)^-1 for a triangle A.
void dtrsm_(const char* side, const char* triangle, const char* transposed, const char* diagonal, const int* m,
            const int* n, const double* alpha, const double* a, const int* stride_a, double* b, const int* stride_b,
            std::size_t, std::size_t, std::size_t, std::size_t);
/// C = alpha A^T A + beta C, in one triangle.
void dsyrk_(const char* triangle, const char* transposed, const int* n, const int* k, const double* alpha,
            const double* a, const int* stride_a, const double* beta, double* c, const int* stride_c, std::size_t,
            std::size_t);
}
// NOLINTEND(readability-identifier-naming)

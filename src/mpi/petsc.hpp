#pragma once
/// Objects of PETSc that end with their owner, and its error codes as exceptions.

#include <petscksp.h>

#include <utility>

namespace creepcontact::mpi {

/// @throws SolverError with PETSc's text if the code is one of an error
void check(PetscErrorCode code);
/// Starts PETSc unless it runs; end_petsc() ends it.
void require_petsc();
void end_petsc();

template <typename Object, PetscErrorCode (*destroy)(Object*)>
class Owned {
 public:
  Owned() = default;
  ~Owned() { reset(); }
  Owned(Owned&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Owned& operator=(Owned&&) = delete;
  Object get() const { return object_; }
  /// For functions that create an object.
  Object* put() {
    reset();
    return &object_;
  }
  void reset() { destroy(&object_); }

 private:
  Object object_ = nullptr;
};

using OwnedMat = Owned<Mat, MatDestroy>;
using OwnedVec = Owned<Vec, VecDestroy>;
using OwnedPC = Owned<PC, PCDestroy>;
using OwnedKSP = Owned<KSP, KSPDestroy>;
using OwnedScatter = Owned<VecScatter, VecScatterDestroy>;
using OwnedNullSpace = Owned<MatNullSpace, MatNullSpaceDestroy>;

}  // namespace creepcontact::mpi

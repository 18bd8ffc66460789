#include "hdf5_library.hpp"

#include <dlfcn.h>

#include <new>
#include <string>
#include <type_traits>

#include "creepcontact/platform/memory.hpp"

namespace creepcontact::io {
namespace {

[[noreturn]] void fail() {
  const char* given = ::dlerror();
  std::string reason = given == nullptr ? "unknown reason" : given;
  if (reason.find("failed to map segment") != std::string::npos) reason += " (too little memory)";
  throw Hdf5Error("cannot load the HDF5 library: " + reason);
}

/// Libraries that begin without memory may crash. Nothing is reserved to find out: BLAS waits for ever for its own.
void require_memory() {
  constexpr double needed = 160 * 1048576.0;  // of HDF5, of libraries it is linked to, and of a thread
  if (platform::address_space().bytes < needed) throw std::bad_alloc();
}

class Loader {
 public:
  Loader() : library_(::dlopen(CREEPCONTACT_HDF5_LIBRARY, RTLD_NOW | RTLD_LOCAL)) {
    if (library_ == nullptr) fail();
    // A program that is linked to the library itself holds the library's variables.
    if (::dlsym(RTLD_DEFAULT, "H5open") == ::dlsym(library_, "H5open")) library_ = RTLD_DEFAULT;
  }

  template <typename Function>
  Function* function(const char* name) const {
    return reinterpret_cast<Function*>(symbol(name));
  }
  hid_t value(const char* name) const { return *static_cast<const hid_t*>(symbol(name)); }

 private:
  void* symbol(const char* name) const {
    void* found = ::dlsym(library_, name);
    if (found == nullptr) fail();
    return found;
  }

  void* library_;  // for good
};

Hdf5Library load() {
  require_memory();
  const Loader loader;
  // Before the library starts: its clean-up at exit prints of, and may crash at, a file that a full disk has kept open.
  loader.function<decltype(::H5dont_atexit)>("H5dont_atexit")();
  if (loader.function<decltype(::H5open)>("H5open")() < 0) throw Hdf5Error("cannot start the HDF5 library");
  Hdf5Library all{};
#define CREEPCONTACT_LOAD(name) all.name = loader.function<decltype(::name)>(#name)
  CREEPCONTACT_LOAD(H5Dclose);
  CREEPCONTACT_LOAD(H5Dcreate2);
  CREEPCONTACT_LOAD(H5Dget_space);
  CREEPCONTACT_LOAD(H5Dopen2);
  CREEPCONTACT_LOAD(H5Dread);
  CREEPCONTACT_LOAD(H5Dwrite);
  CREEPCONTACT_LOAD(H5Eset_auto2);
  CREEPCONTACT_LOAD(H5Fclose);
  CREEPCONTACT_LOAD(H5Fcreate);
  CREEPCONTACT_LOAD(H5Fget_filesize);
  CREEPCONTACT_LOAD(H5Fopen);
  CREEPCONTACT_LOAD(H5Gclose);
  CREEPCONTACT_LOAD(H5Gcreate2);
  CREEPCONTACT_LOAD(H5Gget_info);
  CREEPCONTACT_LOAD(H5Gopen2);
  CREEPCONTACT_LOAD(H5Iget_file_id);
  CREEPCONTACT_LOAD(H5Lget_name_by_idx);
  CREEPCONTACT_LOAD(H5Pclose);
  CREEPCONTACT_LOAD(H5Pcreate);
  CREEPCONTACT_LOAD(H5Pset_userblock);
  CREEPCONTACT_LOAD(H5Sclose);
  CREEPCONTACT_LOAD(H5Screate_simple);
  CREEPCONTACT_LOAD(H5Sget_simple_extent_dims);
  CREEPCONTACT_LOAD(H5Sget_simple_extent_ndims);
  CREEPCONTACT_LOAD(H5Sget_simple_extent_npoints);
#undef CREEPCONTACT_LOAD
  all.file_create_class = loader.value("H5P_CLS_FILE_CREATE_ID_g");
  all.native_double = loader.value("H5T_NATIVE_DOUBLE_g");
  all.native_int64 = loader.value("H5T_NATIVE_INT64_g");
  all.native_char = loader.value(std::is_signed_v<char> ? "H5T_NATIVE_SCHAR_g" : "H5T_NATIVE_UCHAR_g");
  return all;
}

}  // namespace

const Hdf5Library& hdf5() {
  static const Hdf5Library library = load();
  return library;
}

}  // namespace creepcontact::io

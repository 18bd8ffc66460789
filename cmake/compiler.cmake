add_library(creepcontact_options INTERFACE)
# All modules share their precompiled headers, so they share this flag too.
target_link_libraries(creepcontact_options INTERFACE OpenMP::OpenMP_CXX)
# The bits of Eigen's products on several threads depend on their number.
target_compile_definitions(creepcontact_options INTERFACE EIGEN_DONT_PARALLELIZE)
target_compile_options(creepcontact_options INTERFACE -Wall -Wextra -Wconversion -Wno-sign-conversion)
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Names of one source are no shadows in the next, and its types have the linkage of that source.
  target_compile_options(creepcontact_options INTERFACE -Wshadow=local -Wno-subobject-linkage)
else()
  target_compile_options(creepcontact_options INTERFACE -Wshadow)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC collects its garbage less often: a tenth of the time for a twentieth more memory.
  add_compile_options(--param=ggc-min-expand=400)
endif()
# The module for Python is a shared library. What the modules call of each other cannot be replaced in it either.
# Not by CMAKE_POSITION_INDEPENDENT_CODE: precompiled headers would not serve both libraries and programs.
add_compile_options(-fPIC -fno-semantic-interposition)
if(CREEPCONTACT_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
if(CREEPCONTACT_SANITIZE)
  # Left out, for they cost a third of the compilation of Eigen's decompositions: checks of null pointers and of the size of objects,
  # which the address sanitizer sees too, of pointer arithmetic, alignment and dynamic types.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize=null,alignment,vptr,object-size,pointer-overflow
                      -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()

add_library(creepcontact_options INTERFACE)
target_compile_options(creepcontact_options INTERFACE -Wall -Wextra -Wconversion -Wno-sign-conversion -Wshadow)
if(CREEPCONTACT_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
if(CREEPCONTACT_SANITIZE)
  # The address sanitizer sees null pointers too; checks of alignment and dynamic types cost a third of the compilation.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize=null,alignment,vptr -fno-sanitize-recover=undefined
                      -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()

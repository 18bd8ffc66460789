# Installs the build into WORK_DIR/prefix, then builds and runs the consumer against it.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
foreach(file bin/creepcontact libexec/creepcontact/creepcontact-mesher
             libexec/creepcontact/creepcontact-optimizer.so share/creepcontact/configs share/man/man1/creepcontact.1
             share/bash-completion/completions/creepcontact share/doc/creepcontact/docs/configuration.md)
  if(NOT EXISTS ${WORK_DIR}/prefix/${file})
    message(FATAL_ERROR "not installed: ${file}")
  endif()
endforeach()
# The installed program finds the installed mesher.
run(${CMAKE_COMMAND} -E env --unset=CREEPCONTACT_MESHER
    ${WORK_DIR}/prefix/bin/creepcontact check ${WORK_DIR}/prefix/share/creepcontact/configs/pressed_blocks.toml)
if(EXISTS ${WORK_DIR}/prefix/share/creepcontact/configs/results)
  message(FATAL_ERROR "results of earlier runs were installed with the configurations")
endif()
run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/build -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${CXX}
    -D CMAKE_BUILD_TYPE=Release -D CMAKE_PREFIX_PATH=${WORK_DIR}/prefix -D SANITIZE=${SANITIZE})
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${CMAKE_COMMAND} -E env CREEPCONTACT_MESHER=${WORK_DIR}/prefix/libexec/creepcontact/creepcontact-mesher
    ${WORK_DIR}/build/consumer ${WORK_DIR}/results ${WORK_DIR}/prefix/share/creepcontact/configs/pressed_blocks.toml)

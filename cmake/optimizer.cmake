# creepcontact-optimizer.so, which `creepcontact fit` loads: alone in being linked to Ceres, which brings ATLAS. Linked to the
# program, ATLAS would come before OpenBLAS and make every factorisation take twice as long.
find_package(Ceres REQUIRED)
creepcontact_plugin(optimizer creepcontact_optimizer USES creepcontact_fit LIBRARIES Ceres::ceres)
set_target_properties(creepcontact_optimizer PROPERTIES OUTPUT_NAME creepcontact-optimizer)
add_dependencies(creepcontact_fit creepcontact_optimizer)

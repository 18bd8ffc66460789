# creepcontact-optimizer.so, which `creepcontact fit` loads: alone in being linked to Ceres, which brings ATLAS. Linked to the
# program, ATLAS would come before OpenBLAS and make every factorisation take twice as long. (The package of Ceres for CMake sets
# variables of METIS and SuiteSparse that are ours.)
creepcontact_find_library(Ceres ceres/ceres.h ceres)
creepcontact_find_library(Glog glog/logging.h glog)
creepcontact_plugin(optimizer creepcontact_optimizer USES creepcontact_fit LIBRARIES Ceres::Ceres Glog::Glog Eigen3::Eigen)
set_target_properties(creepcontact_optimizer PROPERTIES OUTPUT_NAME creepcontact-optimizer)
add_dependencies(creepcontact_fit creepcontact_optimizer)

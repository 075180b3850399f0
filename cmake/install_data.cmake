# What programs and launch files open at run time, in the places that it has in the source folder.
# Scripts are not executable there, so that rosrun offers programs only.
foreach(folder config rviz urdf)
  install(DIRECTORY ${folder} DESTINATION ${RIBBON_MAPPER_SHARE_DIR})
endforeach()
if(NOT RIBBON_MAPPER_HAS_SIM)
  set(RIBBON_MAPPER_LAUNCH_FILES_OF_SIM PATTERN simulate.launch EXCLUDE PATTERN loop_closure.launch EXCLUDE)
endif()
install(DIRECTORY launch DESTINATION ${RIBBON_MAPPER_SHARE_DIR} ${RIBBON_MAPPER_LAUNCH_FILES_OF_SIM})
install(DIRECTORY worlds DESTINATION ${RIBBON_MAPPER_SHARE_DIR} PATTERN slam_worlds EXCLUDE)
install(DIRECTORY eval/figures DESTINATION ${RIBBON_MAPPER_SHARE_DIR}/eval
  FILES_MATCHING PATTERN "*.py")
install(FILES test/data/small_room.bag test/data/small_room.tum  # for a first try
  DESTINATION ${RIBBON_MAPPER_SHARE_DIR}/test/data)

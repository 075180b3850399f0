# What programs and launch files open at run time, in the places that it has in the source folder.
# Scripts are not executable there, so that rosrun offers programs only.
foreach(folder config launch rviz urdf)
  install(DIRECTORY ${folder} DESTINATION ${RIBBON_MAPPER_SHARE_DIR})
endforeach()
install(DIRECTORY worlds DESTINATION ${RIBBON_MAPPER_SHARE_DIR} PATTERN slam_worlds EXCLUDE)
install(DIRECTORY eval/figures DESTINATION ${RIBBON_MAPPER_SHARE_DIR}/eval
  FILES_MATCHING PATTERN "*.py")
install(FILES test/data/small_room.bag test/data/small_room.tum  # pr2_replay.launch
  DESTINATION ${RIBBON_MAPPER_SHARE_DIR}/test/data)

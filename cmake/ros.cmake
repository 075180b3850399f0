# Messages, services and the catkin package, if ROS 1 is there.
if(NOT DEFINED RIBBON_MAPPER_ROS OR RIBBON_MAPPER_ROS OR RIBBON_MAPPER_ROS STREQUAL AUTO)
  # The environment of the tests lists only folders that exist when catkin is found.
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/devel/lib/python3/dist-packages)
  # A shell that has sourced the devel space must not leave it in what is installed.
  string(REPLACE ":" ";" prefixes "$ENV{CMAKE_PREFIX_PATH}")
  list(REMOVE_ITEM prefixes ${PROJECT_BINARY_DIR}/devel)
  list(JOIN prefixes ":" prefixes)
  #catkin_lint: ignore_once immutable_var
  set(ENV{CMAKE_PREFIX_PATH} "${prefixes}")
  # catkin installs setup.bash and the like to CMAKE_INSTALL_PREFIX, even if cmake --install is given
  # another --prefix: as a relative path, it is right for both.
  if(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
    set(CMAKE_INSTALL_PREFIX .)
  endif()
  find_package(catkin QUIET COMPONENTS
    diagnostic_updater geometry_msgs message_generation nav_msgs rosbag roscpp rosgraph_msgs
    sensor_msgs std_msgs std_srvs tf2 tf2_eigen tf2_ros topic_tools visualization_msgs)
  # As the path is relative, catkin may leave a relay to the install space where the devel space has
  # the script behind setup.bash. It is written once more, and what was run by it is run again.
  if(catkin_FOUND AND CATKIN_INSTALL_INTO_PREFIX_ROOT AND PROJECT_SOURCE_DIR STREQUAL CMAKE_SOURCE_DIR)
    file(REMOVE ${CATKIN_DEVEL_PREFIX}/_setup_util.py)
    set(CATKIN_INSTALL_INTO_PREFIX_ROOT OFF)
    catkin_generate_environment()
    set(CATKIN_INSTALL_INTO_PREFIX_ROOT ON)
    safe_execute_process(COMMAND ${GENERATE_ENVIRONMENT_CACHE_COMMAND})
  endif()
  unset(CMAKE_INSTALL_PREFIX)
endif()
set(libraries catkin=catkin)
if(catkin_FOUND)
  list(APPEND libraries
    diagnostic_updater=libdiagnostic-updater-dev geometry_msgs=libgeometry-msgs-dev
    message_generation=ros-message-generation nav_msgs=libnav-msgs-dev rosbag=librosbag-dev
    roscpp=libroscpp-dev rosgraph_msgs=libros-rosgraph-msgs-dev sensor_msgs=libsensor-msgs-dev
    std_msgs=libstd-msgs-dev std_srvs=libstd-srvs-dev tf2=libtf2-dev
    tf2_eigen=libtf2-eigen-dev tf2_ros=libtf2-ros-dev topic_tools=libtopic-tools-dev
    visualization_msgs=libvisualization-msgs-dev)
endif()
ribbon_mapper_part(ROS "the ROS nodes" PARTS IO MESH LIBRARIES ${libraries})
if(NOT RIBBON_MAPPER_HAS_ROS)
  return()
endif()

add_message_files(DIRECTORY msg FILES
  BoundedPlane.msg FloorPassage.msg FloorRoom.msg FloorRooms.msg PlaneArray.msg PlaneOutline.msg)
add_service_files(DIRECTORY srv FILES Annotate.srv GetModel.srv Load.srv Save.srv)
generate_messages(DEPENDENCIES geometry_msgs std_msgs)
# The messages' headers are exported by themselves, those of the library with its targets.
catkin_package(
  LIBRARIES ribbon_mapper_core
  CATKIN_DEPENDS geometry_msgs message_runtime std_msgs
  CFG_EXTRAS ribbon_mapper-extras.cmake)

# rosrun looks everywhere in a package but in its build/, where plain CMake has the devel space.
string(FIND "${CATKIN_DEVEL_PREFIX}/" "${PROJECT_SOURCE_DIR}/build/" place)
if(place EQUAL 0)
  file(CREATE_LINK ${CATKIN_DEVEL_PREFIX} ${PROJECT_SOURCE_DIR}/devel SYMBOLIC)
endif()

# Debian's libzmq3-dev carries pkg-config only. Defines ZeroMQ::zmq.
find_path(ZMQ_INCLUDE_DIR zmq.h)
find_library(ZMQ_LIBRARY zmq)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ZeroMQ REQUIRED_VARS ZMQ_LIBRARY ZMQ_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "install libzmq3-dev (scripts/setup does)")
if(ZeroMQ_FOUND AND NOT TARGET ZeroMQ::zmq)
  add_library(ZeroMQ::zmq UNKNOWN IMPORTED)
  set_target_properties(ZeroMQ::zmq PROPERTIES IMPORTED_LOCATION ${ZMQ_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${ZMQ_INCLUDE_DIR})
endif()

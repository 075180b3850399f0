# Whether the Python package can be built. Needs the part IO.
include_guard(GLOBAL)

find_package(Python3 QUIET COMPONENTS Interpreter OPTIONAL_COMPONENTS Development)
find_package(pybind11 2.6 QUIET)
set(pybind11_2.6_FOUND ${pybind11_FOUND})
ribbon_mapper_part(PYTHON "the Python package" PARTS IO LIBRARIES
  Python3_Development=python3-dev "pybind11_2.6=pybind11-dev (2.6 or later)")

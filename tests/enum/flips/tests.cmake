hexatlas_test(enum_flips_quad_flip_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/quad_flip_test.cpp
  USES enum_flips)
hexatlas_test(enum_flips_flip_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/flip_test.cpp
  USES enum_flips)
hexatlas_test(enum_flips_front_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/front_test.cpp
  USES enum_flips)
hexatlas_test(enum_flips_census_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/census_test.cpp
  USES enum_flips enum_canon_nauty)
hexatlas_test(enum_flips_beam_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/beam_test.cpp
  USES enum_flips)
hexatlas_test(enum_flips_meeting_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/meeting_test.cpp
  USES enum_flips)
hexatlas_test(enum_flips_spindle_test long
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/spindle_test.cpp
  USES enum_flips enum_parallel)

hexatlas_test(enum_flips_replacement_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/replacement_test.cpp
  USES enum_flips)
hexatlas_test(enum_flips_walk_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/walk_test.cpp
  USES enum_flips)
hexatlas_test(enum_flips_annealing_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/annealing_test.cpp
  USES enum_flips)
hexatlas_test(enum_flips_beam_bytes_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/beam_bytes_test.cpp
  USES enum_flips)
hexatlas_test(enum_flips_disc_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/disc_test.cpp
  USES enum_flips)
hexatlas_test(enum_flips_cut_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/cut_test.cpp
  USES enum_flips)
hexatlas_test(enum_flips_peeling_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/peeling_test.cpp
  USES enum_flips enum_quads)
hexatlas_test(enum_flips_reducing_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/reducing_test.cpp
  USES enum_flips)
hexatlas_test(enum_flips_symmetric_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/symmetric_front_test.cpp
  USES enum_flips enum_quads)

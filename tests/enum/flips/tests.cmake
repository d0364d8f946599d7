hexatlas_tests(enum_flips fast
  SOURCES annealing_test.cpp beam_bytes_test.cpp beam_test.cpp census_test.cpp crown_test.cpp cut_test.cpp disc_test.cpp
    faulty_cut_test.cpp faulty_meeting_test.cpp flip_test.cpp front_test.cpp matching_test.cpp meeting_test.cpp peeling_test.cpp quad_flip_test.cpp reducing_test.cpp
    replacement_test.cpp sharp_zones_test.cpp symmetric_balls_test.cpp symmetric_front_test.cpp symmetric_walk_test.cpp transplant_test.cpp walk_test.cpp
  USES enum_flips enum_quads enum_canon_nauty)
hexatlas_tests(enum_flips long SOURCES spindle_test.cpp USES enum_flips enum_parallel)

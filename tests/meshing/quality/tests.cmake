hexatlas_tests(meshing_quality fast
  SOURCES cells_test.cpp hexahedron_test.cpp least_shape_test.cpp report_test.cpp self_meeting_test.cpp volume_test.cpp
  APART least_shape_test.cpp
  USES meshing_quality)

hexatlas_test(meshing_quality_test fast
  SOURCES quality/hexahedron_test.cpp quality/report_test.cpp quality/volume_test.cpp quality/self_meeting_test.cpp
  USES meshing_quality)
hexatlas_test(meshing_quality_cells_test fast SOURCES quality/cells_test.cpp quality/least_shape_test.cpp USES meshing_quality)

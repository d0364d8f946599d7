hexatlas_tests(meshing_view fast SOURCES structure_test.cpp USES meshing_view)

hexatlas_tests(tables_check fast
  SOURCES bound_rules_test.cpp completeness_test.cpp laws_test.cpp quad_code_test.cpp refutation_test.cpp
    rooted_count_test.cpp
  APART completeness_test.cpp
  USES tables_check tables_format enum_canon)
hexatlas_tests(tables_check_files fast SHORT
  SOURCES file_bytes_test.cpp lrat_test.cpp mesh_check_test.cpp read_binary_vtk_test.cpp read_mesh_test.cpp
    read_points_test.cpp sectors_test.cpp table_check_test.cpp
  USES tables_check tables_format meshing_io enum_canon)
hexatlas_tests(tables_check_delaunay fast
  SOURCES delaunay_check_test.cpp regular_check_test.cpp
  USES tables_check)
hexatlas_tests(tables_check_hybrid fast SOURCES hybrid_check_test.cpp USES tables_check meshing_io)
hexatlas_tests(tables_check long
  SOURCES catalogue_test.cpp completeness_proof_test.cpp rooted_count_test.cpp
  USES tables_check tables_format realize_solve enum_canon)

hexatlas_tests(tables_build fast
  SOURCES bounds_test.cpp census_test.cpp named_test.cpp search_test.cpp
  USES tables_build tables_check enum_canon enum_flips enum_hexes)

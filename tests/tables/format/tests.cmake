hexatlas_tests(tables_format fast SHORT
  SOURCES catalogue_test.cpp record_test.cpp sectors_test.cpp table_test.cpp
  USES tables_format tables_check enum_flips enum_canon_nauty)

hexatlas_tests(tables_sheet fast SHORT
  SOURCES contact_sheet_test.cpp distribution_chart_test.cpp
  USES tables_sheet)

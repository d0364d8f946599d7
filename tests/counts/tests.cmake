foreach(label fast long)
  hexatlas_tests(counts ${label}
    SOURCES quadrangulations_test.cpp
    USES enum_canon enum_canon_nauty enum_flips)
endforeach()

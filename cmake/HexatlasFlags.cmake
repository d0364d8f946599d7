# Flags of every target. Exact predicates need strict IEEE arithmetic, hence no fused
# multiply-add behind our back and never -ffast-math.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3")  # without NDEBUG: nothing here hides behind assert

add_compile_options(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor
  -Wold-style-cast -Wcast-align -Woverloaded-virtual -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports overlapping copies inside std::string that are not there (GCC bug 105651).
  add_compile_options(-Wno-restrict)
else()
  add_compile_options(-Wreserved-identifier -Wno-missing-braces)
endif()
add_compile_options(-Wno-sign-conversion)  # indices are unsigned by type, arrays by size_t
if(HEXATLAS_WERROR)
  add_compile_options(-Werror)
endif()
if(HEXATLAS_CHECKED)
  add_compile_definitions(HEXATLAS_CHECKED=1)
endif()
if(HEXATLAS_SANITIZE)
  add_compile_options(-fsanitize=${HEXATLAS_SANITIZE} -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${HEXATLAS_SANITIZE})
  # A program that may be loaded anywhere has 130,000 places to put right at its start, nearly all of
  # UndefinedBehaviorSanitizer: a third of the time of a short run.
  if(HEXATLAS_SANITIZE MATCHES "address")
    add_compile_options(-fno-pie)
    add_link_options(-no-pie)
  endif()
  # AddressSanitizer looks at each access itself; to look at its pointer as well takes a third of
  # the compiler's time. Casts of pointers are to bytes only, so that each is aligned.
  if(HEXATLAS_SANITIZE MATCHES "address" AND HEXATLAS_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize=pointer-overflow,null,object-size,alignment)
  endif()
  if(HEXATLAS_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link)
  endif()
endif()

# The tests are a hundred programs, each of which lld links in a third of the time.
if(HEXATLAS_TESTS)
  find_program(HEXATLAS_LLD ld.lld)
  if(HEXATLAS_LLD)
    add_link_options(-fuse-ld=lld)
  endif()
endif()

# Of what is compiled more often than it runs; and of what hardly runs at all: to optimize what
# AddressSanitizer has made of it takes three quarters of its compiling.
set(HEXATLAS_COLD_OPTIONS $<$<CONFIG:Release,RelWithDebInfo>:-O1>)
set(HEXATLAS_COLDEST_OPTIONS ${HEXATLAS_COLD_OPTIONS})
if(HEXATLAS_SANITIZE MATCHES "address")
  set(HEXATLAS_COLDEST_OPTIONS -O0)
endif()

// The headers that tests have in common are compiled with this file: see CMakeLists.txt.

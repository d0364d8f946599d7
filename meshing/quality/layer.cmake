hexatlas_layer(meshing/quality
  HEADERS hexahedron.hpp report.hpp box_tree.hpp self_meeting.hpp
  SOURCES hexahedron.cpp report.cpp box_tree.cpp self_meeting.cpp
  USES enum/core realize/exact meshing/mesh)

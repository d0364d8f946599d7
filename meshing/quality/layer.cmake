hexatlas_layer(meshing/quality
  HEADERS hexahedron.hpp cells.hpp edge.hpp report.hpp box_tree.hpp self_meeting.hpp
  SOURCES hexahedron.cpp cells.cpp report.cpp verdict.hpp box_tree.cpp self_meeting.cpp
  USES enum/core realize/exact meshing/mesh)

hexatlas_layer(meshing/quality
  HEADERS hexahedron.hpp cells.hpp edge.hpp least_shape.hpp vector.hpp volume.hpp report.hpp
    box_tree.hpp self_meeting.hpp
  SOURCES hexahedron.cpp cells.cpp least_shape.cpp volume.cpp report.cpp verdict.hpp
    box_tree.cpp self_meeting.cpp
  APART least_shape.cpp | self_meeting.cpp
  USES enum/core enum/cells realize/exact meshing/mesh)

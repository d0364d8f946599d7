hexatlas_layer(meshing/simplify
  HEADERS cavity.hpp edited_mesh.hpp known_balls.hpp simplify.hpp small_meshes.hpp
  SOURCES cavity.cpp edited_mesh.cpp known_balls.cpp simplify.cpp small_meshes.cpp
  USES enum/core enum/cells enum/complex enum/canon enum/search enum/flips enum/hexes tables/format tables/fill)

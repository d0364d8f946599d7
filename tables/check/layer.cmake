# The judge: includes no file of another layer, links nothing of ours.
hexatlas_layer(tables/check
  HEADERS ball.hpp bound.hpp bound_file.hpp bound_partners.hpp bound_paths.hpp bound_rules.hpp bound_sphere.hpp bound_state.hpp canonical_form.hpp catalogue.hpp catalogue_points.hpp catalogue_read.hpp
    cell_laws.hpp chirotope_clauses.hpp circuits.hpp jacobian.hpp refutation.hpp shelling.hpp
    text_lines.hpp triangulation_laws.hpp wide.hpp zstd_frame.hpp completeness.hpp completeness_rules.hpp completeness_shapes.hpp
    delaunay_check.hpp delaunay_laws.hpp disjoint_sets.hpp edge_lemma.hpp exact.hpp file_bytes.hpp hybrid_cells.hpp hybrid_check.hpp hybrid_laws.hpp incidence.hpp rooted_count.hpp judge_cells.hpp laws.hpp lrat.hpp malformed.hpp
    mesh.hpp mesh_check.hpp payload.hpp quad_code.hpp readers.hpp scanner.hpp sectors.hpp
    sha256.hpp signs.hpp table_check.hpp table_layout.hpp tetrahedron_facets.hpp verdict.hpp vtu_data.hpp
  SOURCES ball.cpp bound.cpp bound_file.cpp bound_partners.cpp bound_paths.cpp bound_rules.cpp bound_sphere.cpp bound_state.cpp canonical_form.cpp catalogue_laws.cpp catalogue_points.cpp catalogue_read.cpp
    cell_laws.cpp chirotope_clauses.cpp jacobian.cpp refutation.cpp shelling.cpp text_lines.cpp
    triangulation_laws.cpp zstd_frame.cpp completeness.cpp completeness_file.cpp completeness_rules.cpp
    completeness_shapes.cpp delaunay_check.cpp delaunay_hidden.cpp delaunay_hull.cpp edge_lemma.cpp file_bytes.cpp hybrid_boundary.cpp hybrid_cells.cpp hybrid_check.cpp hybrid_laws.cpp incidence.cpp judge_cells.cpp laws.cpp links.cpp lrat.cpp
    mesh_check.cpp payload.cpp quad_code.cpp rooted_count.cpp read_gmsh.cpp read_legacy_vtk.cpp read_medit.cpp read_mesh.cpp
    read_ply.cpp read_points.cpp read_polygons.cpp read_vtu.cpp scanner.cpp sectors.cpp sha256.cpp signs.cpp table_check.cpp table_layout.cpp
    tetrahedron_facets.cpp vtu_data.cpp
  APART ball.cpp chirotope_clauses.cpp completeness_shapes.cpp delaunay_hull.cpp hybrid_boundary.cpp
    hybrid_cells.cpp hybrid_laws.cpp payload.cpp quad_code.cpp read_medit.cpp read_mesh.cpp read_points.cpp
    refutation.cpp scanner.cpp sectors.cpp | read_ply.cpp read_polygons.cpp table_layout.cpp
  THIRD_PARTY PkgConfig::gmp PkgConfig::zstd ZLIB::ZLIB pugixml::pugixml)

hexatlas_layer(tables/sheet
  HEADERS contact_sheet.hpp contact_sheet_layout.hpp contact_sheet_occlusion.hpp
    contact_sheet_relax.hpp contact_sheet_scene.hpp contact_sheet_style.hpp contact_sheet_svg.hpp distribution_chart.hpp
    markup.hpp
  SOURCES contact_sheet.cpp contact_sheet_layout.cpp contact_sheet_occlusion.cpp
    contact_sheet_relax.cpp contact_sheet_scene.cpp contact_sheet_style.cpp contact_sheet_svg.cpp
    distribution_chart.cpp markup.cpp
  USES enum/core enum/complex realize/certificate tables/format
  THIRD_PARTY fmt::fmt)

hexatlas_layer(tables/format
  HEADERS bytes.hpp catalogue.hpp cavity.hpp frame.hpp layout.hpp manifest.hpp record.hpp
    sectors.hpp sha256.hpp table.hpp
  SOURCES catalogue_read.cpp catalogue_write.cpp cavity.cpp frame.cpp manifest.cpp reader.cpp
    record.cpp sectors.cpp sha256.cpp writer.cpp
  APART reader.cpp | record.cpp sectors.cpp sha256.cpp
  USES enum/core enum/cells enum/complex enum/canon realize/certificate
  THIRD_PARTY PkgConfig::zstd OpenSSL::Crypto nlohmann_json::nlohmann_json)

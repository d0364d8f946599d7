hexatlas_layer(tables/format
  HEADERS bytes.hpp cavity.hpp layout.hpp manifest.hpp record.hpp sha256.hpp table.hpp
  SOURCES cavity.cpp manifest.cpp reader.cpp record.cpp sha256.cpp writer.cpp
  USES enum/core enum/cells enum/complex enum/canon
  THIRD_PARTY PkgConfig::zstd OpenSSL::Crypto nlohmann_json::nlohmann_json)

// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/netcdf/memory_file.h"

#include <cstdlib>
#include <memory>

namespace glider::support {
namespace {

constexpr int kDeflateLevel = 1;  // most of a column is fill values: more gains little

}  // namespace

NetcdfMemoryFile::NetcdfMemoryFile() : nc_(NetcdfLibrary::get()), error_(nc_.error) {
  run([&] { return nc_.create_mem("glidercc", NC_NETCDF4 | NC_CLASSIC_MODEL, 0, &id_); }, "");
  open_ = good();
}

NetcdfMemoryFile::~NetcdfMemoryFile() {
  if (open_) {
    nc_.abort(id_);
  }
}

int NetcdfMemoryFile::dimension(const char* name, size_t size) {
  int id = -1;
  run([&] { return nc_.def_dim(id_, name, size, &id); }, name);
  return id;
}

int NetcdfMemoryFile::variable(const std::string& name, nc_type type, int along) {
  int id = -1;
  run([&] { return nc_.def_var(id_, name.c_str(), type, 1, &along, &id); }, name);
  run([&] { return nc_.def_var_deflate(id_, id, 1, 1, kDeflateLevel); }, name);
  return id;
}

int NetcdfMemoryFile::scalar(const std::string& name, nc_type type) {
  int id = -1;
  run([&] { return nc_.def_var(id_, name.c_str(), type, 0, nullptr, &id); }, name);
  return id;
}

void NetcdfMemoryFile::attribute(int variable, const char* name, std::string_view text) {
  run([&] { return nc_.put_att_text(id_, variable, name, text.size(), text.data()); }, name);
}

void NetcdfMemoryFile::fill(int variable, nc_type type, double value) {
  run([&] { return nc_.put_att_double(id_, variable, "_FillValue", type, 1, &value); }, "");
}

void NetcdfMemoryFile::attributeBytes(int variable, const char* name,
                                      const std::vector<signed char>& values) {
  run([&] { return nc_.put_att_schar(id_, variable, name, NC_BYTE, values.size(), values.data()); },
      name);
}

void NetcdfMemoryFile::endDefinitions() {
  run([&] { return nc_.enddef(id_); }, "");
}

void NetcdfMemoryFile::put(int variable, const std::vector<double>& values,
                           const std::string& name) {
  const size_t start = 0, count = values.size();
  if (count > 0) {
    run([&] { return nc_.put_vara_double(id_, variable, &start, &count, values.data()); }, name);
  }
}

void NetcdfMemoryFile::putFloats(int variable, const std::vector<double>& values,
                                 const std::string& name) {
  const size_t start = 0, count = values.size();
  std::vector<float> floats;
  for (const double value : values) {
    floats.push_back(static_cast<float>(value));
  }
  if (count > 0) {
    run([&] { return nc_.put_vara_float(id_, variable, &start, &count, floats.data()); }, name);
  }
}

std::string NetcdfMemoryFile::close() {
  NC_memio memory{};
  if (good()) {
    open_ = false;
    check(nc_.close_memio(id_, &memory), "");
  }
  const std::unique_ptr<void, decltype(&std::free)> owner(memory.memory, &std::free);
  return good() ? std::string(static_cast<const char*>(memory.memory), memory.size) : "";
}

void NetcdfMemoryFile::check(int status, const std::string& name) {
  if (status != NC_NOERR) {
    error_ = (name.empty() ? "" : "`" + name + "`: ") + nc_.strerror(status);
  }
}

}  // namespace glider::support

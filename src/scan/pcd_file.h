#pragma once

#include <string>
#include <vector>

#include <pcl/PCLPointCloud2.h>

#include "weld_profiler/core/atomic_file.h"
#include "weld_profiler/scan/cloud_record.h"

namespace weld_profiler
{
/// A cloud of `width` x rows whose points are `point_step` bytes and begin with a CloudRecord; the points are to be
/// filled in.
pcl::PCLPointCloud2 emptyPclCloud(std::size_t width, std::size_t rows, std::size_t point_step);

/// Another field of its points.
void addField(pcl::PCLPointCloud2& cloud, const char* name, std::uint32_t offset, std::uint8_t type);

/// Writes a cloud as binary PCD. PCL makes the header; its own writer maps the file into memory, where a full disk is a
/// SIGBUS and no error.
/// @param comments  for its head, one line each.
/// @throws InputError naming path and cause.
void writePcd(const pcl::PCLPointCloud2& cloud, const AtomicFile& file, const std::vector<std::string>& comments);
}  // namespace weld_profiler

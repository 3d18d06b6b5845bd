#pragma once

#include <geometry_msgs/PoseArray.h>
#include <pcl_msgs/PolygonMesh.h>
#include <sensor_msgs/PointCloud2.h>
#include <shape_msgs/Mesh.h>
#include <Eigen/Geometry>

#include "weld_profiler/GrindingPasses.h"
#include "weld_profiler/weld/grinding.h"

namespace weld_profiler
{
/// The same plan in another frame. @param to_T_plan  maps points of the plan.
GrindingPlan transformed(const GrindingPlan& plan, const Eigen::Isometry3d& to_T_plan, const std::string& frame);

/// x, y, z of a cloud in another frame; all else stays. @param to_T_cloud  maps points of the cloud.
void transformCloud(sensor_msgs::PointCloud2& cloud, const Eigen::Isometry3d& to_T_cloud, const std::string& frame);

/// All lines one after the other. @param header  its frame is the plan's.
geometry_msgs::PoseArray poseArray(const std::vector<PoseLine>& lines, const std_msgs::Header& header);

/// All passes.
GrindingPasses passesMessage(const GrindingPlan& plan, const std_msgs::Header& header);

/// All poses of all passes, in order.
geometry_msgs::PoseArray passPoses(const GrindingPlan& plan, const std_msgs::Header& header);

shape_msgs::Mesh shapeMessage(const TriangleMesh& mesh);

/// With vertex normals: x y z normal_x normal_y normal_z.
pcl_msgs::PolygonMesh polygonMessage(const TriangleMesh& mesh, const std_msgs::Header& header);
}  // namespace weld_profiler

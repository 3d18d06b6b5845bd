#include "weld_profiler/ros/grinding_messages.h"

#include <array>
#include <cstring>

namespace weld_profiler
{
namespace
{
geometry_msgs::Pose poseMessage(const SurfacePose& pose)
{
  geometry_msgs::Pose message;
  message.position.x = pose.position.x();
  message.position.y = pose.position.y();
  message.position.z = pose.position.z();
  message.orientation.x = pose.orientation.x();
  message.orientation.y = pose.orientation.y();
  message.orientation.z = pose.orientation.z();
  message.orientation.w = pose.orientation.w();
  return message;
}

void move(const Eigen::Isometry3d& by, SurfacePose& pose)
{
  pose.position = by * pose.position;
  pose.orientation = Eigen::Quaterniond(by.linear()) * pose.orientation;
}

void move(const Eigen::Isometry3d& by, TriangleMesh& mesh)
{
  for (Eigen::Vector3f& vertex : mesh.vertices)
    vertex = (by * vertex.cast<double>()).cast<float>();
  for (Eigen::Vector3f& normal : mesh.normals)
    normal = (by.linear() * normal.cast<double>()).cast<float>();
}
}  // namespace

GrindingPlan transformed(const GrindingPlan& plan, const Eigen::Isometry3d& to_T_plan, const std::string& frame)
{
  GrindingPlan moved = plan;
  moved.frame_id = frame;
  for (std::vector<PoseLine>* lines : { &moved.toe_left, &moved.toe_right, &moved.crest })
    for (PoseLine& line : *lines)
      for (SurfacePose& pose : line)
        move(to_T_plan, pose);
  for (GrindingPass& pass : moved.passes)
  {
    for (GrindingPoint& point : pass.points)
      move(to_T_plan, point.pose);
    move(to_T_plan, pass.approach);
    move(to_T_plan, pass.retract);
  }
  move(to_T_plan, moved.bead);
  move(to_T_plan, moved.target);
  return moved;
}

void transformCloud(sensor_msgs::PointCloud2& cloud, const Eigen::Isometry3d& to_T_cloud, const std::string& frame)
{
  cloud.header.frame_id = frame;
  for (std::size_t at = 0; at + cloud.point_step <= cloud.data.size(); at += cloud.point_step)
  {
    float place[3];  // the first three fields
    std::memcpy(place, &cloud.data[at], sizeof(place));
    const Eigen::Vector3d moved = to_T_cloud * Eigen::Vector3d(place[0], place[1], place[2]);
    for (int i = 0; i < 3; ++i)
      place[i] = static_cast<float>(moved[i]);
    std::memcpy(&cloud.data[at], place, sizeof(place));
  }
}

geometry_msgs::PoseArray poseArray(const std::vector<PoseLine>& lines, const std_msgs::Header& header)
{
  geometry_msgs::PoseArray message;
  message.header = header;
  for (const PoseLine& line : lines)
    for (const SurfacePose& pose : line)
      message.poses.push_back(poseMessage(pose));
  return message;
}

GrindingPasses passesMessage(const GrindingPlan& plan, const std_msgs::Header& header)
{
  GrindingPasses message;
  message.header = header;
  message.reason = plan.reason;
  message.removal_volume = plan.removal_volume;
  message.planned_volume = plan.planned_volume;
  for (const GrindingPass& pass : plan.passes)
  {
    geometry_msgs::PoseArray poses;
    poses.header = header;
    for (const GrindingPoint& point : pass.points)
      poses.poses.push_back(poseMessage(point.pose));
    message.passes.push_back(poses);
    message.approach.push_back(poseMessage(pass.approach));
    message.retract.push_back(poseMessage(pass.retract));
    message.layer.push_back(static_cast<std::uint32_t>(pass.layer));
  }
  return message;
}

geometry_msgs::PoseArray passPoses(const GrindingPlan& plan, const std_msgs::Header& header)
{
  geometry_msgs::PoseArray message;
  message.header = header;
  for (const GrindingPass& pass : plan.passes)
    for (const GrindingPoint& point : pass.points)
      message.poses.push_back(poseMessage(point.pose));
  return message;
}

shape_msgs::Mesh shapeMessage(const TriangleMesh& mesh)
{
  shape_msgs::Mesh message;
  for (const Eigen::Vector3f& vertex : mesh.vertices)
  {
    geometry_msgs::Point point;
    point.x = static_cast<double>(vertex.x());
    point.y = static_cast<double>(vertex.y());
    point.z = static_cast<double>(vertex.z());
    message.vertices.push_back(point);
  }
  for (const std::array<std::uint32_t, 3>& corners : mesh.triangles)
  {
    shape_msgs::MeshTriangle triangle;
    for (std::size_t i = 0; i < 3; ++i)
      triangle.vertex_indices[i] = corners[i];
    message.triangles.push_back(triangle);
  }
  return message;
}

pcl_msgs::PolygonMesh polygonMessage(const TriangleMesh& mesh, const std_msgs::Header& header)
{
  const std::array<const char*, 6> names = { { "x", "y", "z", "normal_x", "normal_y", "normal_z" } };
  pcl_msgs::PolygonMesh message;
  message.header = message.cloud.header = header;
  message.cloud.height = 1;
  message.cloud.width = static_cast<std::uint32_t>(mesh.vertices.size());
  message.cloud.is_dense = true;
  for (const char* name : names)
  {
    sensor_msgs::PointField field;
    field.name = name;
    field.offset = static_cast<std::uint32_t>(sizeof(float) * message.cloud.fields.size());
    field.datatype = sensor_msgs::PointField::FLOAT32;
    field.count = 1;
    message.cloud.fields.push_back(field);
  }
  message.cloud.point_step = static_cast<std::uint32_t>(sizeof(float) * names.size());
  message.cloud.row_step = message.cloud.width * message.cloud.point_step;
  message.cloud.data.resize(message.cloud.row_step);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
  {
    const Eigen::Vector3f& p = mesh.vertices[i];
    const Eigen::Vector3f& n = mesh.normals[i];
    const float record[6] = { p.x(), p.y(), p.z(), n.x(), n.y(), n.z() };
    std::memcpy(&message.cloud.data[i * sizeof(record)], record, sizeof(record));
  }
  for (const std::array<std::uint32_t, 3>& corners : mesh.triangles)
  {
    pcl_msgs::Vertices triangle;
    triangle.vertices.assign(corners.begin(), corners.end());
    message.polygons.push_back(triangle);
  }
  return message;
}
}  // namespace weld_profiler

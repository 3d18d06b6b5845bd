# shellcheck shell=bash
# Sourced by the other scripts: where things are, and an environment that does not depend on the caller's.
# Sets root, build; defines say, die, jobs, enter_built_environment.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
build=${WELD_PROFILER_BUILD:-$root/build}

# Debian's ROS belongs to Debian's python: a pyenv or a virtual environment in front of it hides catkin_pkg.
export PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
# Left over from another workspace: they would take the place of what is built here.
unset PYTHONPATH PYTHONHOME VIRTUAL_ENV PYENV_VERSION
unset CMAKE_PREFIX_PATH ROS_PACKAGE_PATH ROS_ROOT ROS_DISTRO ROS_ETC_DIR
unset LD_PRELOAD
# Without a name that resolves, every node dies of "Name or service not known" (containers, laptops off the network).
if [ -z "${ROS_HOSTNAME:-}" ] && [ -z "${ROS_IP:-}" ]; then
  export ROS_HOSTNAME=localhost
fi
if [ -f /opt/ros/noetic/setup.bash ]; then
  set +u
  . /opt/ros/noetic/setup.bash
  set -u
fi

say() { printf '%s: %s\n' "${0##*/}" "$*" >&2; }
die() { say "$*"; exit 1; }

# How many compilers fit: one a core, 1.5 GB of free memory each (PCL's headers want it).
jobs_that_fit() {
  local cores memory_kb
  cores=$(nproc)
  memory_kb=$(awk '/^MemAvailable:/ { print $2 }' /proc/meminfo)
  local by_memory=$(( ${memory_kb:-0} / 1500000 ))
  [ "$by_memory" -ge 1 ] || by_memory=1
  echo $(( cores < by_memory ? cores : by_memory ))
}

# What `source devel/setup.bash` does, after scripts/setup built it.
enter_built_environment() {
  [ -f "$build/devel/setup.bash" ] || die "$build/devel/setup.bash is missing, run scripts/setup first"
  set +u  # catkin's script reads unset variables
  . "$build/devel/setup.bash"
  set -u
}

"""Messages without their Python packages: classes made at run time from the definition that travels with each topic.

Debian packs the Python of std_srvs and diagnostic_msgs apart from what roslaunch and the nodelets need.
"""
import genpy.dynamic
import rospy


def _message_class(name, definition):
    return genpy.dynamic.generate_dynamic(name, definition)[name]


class Trigger:
    """std_srvs/Trigger, for rospy.ServiceProxy."""
    _type = "std_srvs/Trigger"
    _md5sum = "937c9679a518e3a18d831e57125ea522"
    _request_class = _message_class("std_srvs/TriggerRequest", "")
    _response_class = _message_class("std_srvs/TriggerResponse", "bool success\nstring message\n")


def subscribe(topic, callback, queue_size):
    """Subscribes to a topic whatever its type is, and hands over messages of that type."""
    classes = {}

    def on_message(raw):
        name = raw._connection_header["type"]
        if name not in classes:
            classes[name] = _message_class(name, raw._connection_header["message_definition"])
        callback(classes[name]().deserialize(raw._buff))

    return rospy.Subscriber(topic, rospy.AnyMsg, on_message, queue_size=queue_size)

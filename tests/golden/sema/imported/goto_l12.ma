behavior_name=goto_list
<start:waypoints>
# none yet
<end:waypoints>

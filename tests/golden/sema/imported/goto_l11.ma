behavior_name=goto_list
<start:waypoints>
-7349.8
-7349.8 39N
-45.5 39.1
-7349.8 3910.5 2
<end:waypoints>

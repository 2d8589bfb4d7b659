behavior_name=goto_list
<start:waypoints>
-7360.5 3910.5
-7349.8 9910.5
<end:waypoints>

# Pictures that the command writes are judged by OpenImageIO itself.
set(link gw_judge_loader)

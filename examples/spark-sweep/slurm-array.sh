#!/bin/bash
#SBATCH --array=0-15 --cpus-per-task=4 --requeue
java -cp 'spark-sweep-1.jar:lib/*' robosim.geometry.cli.Main sweep example.Patrol worlds/*.xml -p keep=0.25,0.5,1 \
  -n 10000 --threads "$SLURM_CPUS_PER_TASK" --shard "$SLURM_ARRAY_TASK_ID/16" --resume
# 1 tells that replicates failed, which starting again would not change: done, where the results are there.
test $? -le 1 -a -s "sweep-$SLURM_ARRAY_TASK_ID-of-16.jsonl" || exit 2
# Then: java -cp ... robosim.geometry.cli.Main sweep merge sweep-*-of-16.jsonl --out sweep.jsonl --digest

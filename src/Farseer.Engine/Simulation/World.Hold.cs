using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Joints;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Simulation;

/// <summary>Which surfaces are not held before they have sunk in as far as is allowed.</summary>
internal sealed partial class World
{
    /// <summary>
    /// Surfaces of islands with joints sink in as far as is allowed: if they yielded nothing at all they would gather impulses against joints that
    /// contradict them, without bound.
    /// </summary>
    private unsafe void LetJointedSink()
    {
        int mark = Scratch.Mark;
        float* jointed = Scratch.Take<float>(Math.Max(1, _islands.Count));
        Unsafe.InitBlock(jointed, 0, (uint)_islands.Count * sizeof(float));
        bool any = false;
        for (int joint = 0; joint < Joints.Ids.End; joint++)
        {
            const JointFlags Acts = JointFlags.Alive | JointFlags.Enabled;
            if ((Joints.Flags[joint] & Acts) == Acts)
            {
                JointLink link = Joints.Links[joint];
                any |= MarkIsland(jointed, link.BodyA) | MarkIsland(jointed, link.BodyB);
            }
        }

        int* islands = stackalloc int[ContactBundle.Lanes];
        foreach (GraphColor color in any ? _graph.Used : default)
        {
            foreach (ContactBundle* row in color.Bundles)
            {
                int sinking = 0;
                for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
                {
                    Wide marks = WideTable.ReadThrough(jointed, _islands.OfSlot, row->Slot + lane, islands + lane);
                    sinking |= WideLanes.Bits(marks > Wide.Zero) << lane;
                }

                for (int lane = 0; sinking != 0; lane++, sinking >>= 1)
                {
                    if ((sinking & 1) != 0 && row->Contact[lane] >= 0)
                    {
                        ContactBundle.LetSink(row, lane);
                    }
                }
            }
        }

        Scratch.Release(mark);
    }

    private unsafe bool MarkIsland(float* islands, int body)
    {
        if (_lists.Moves[body] == 0 || _graph.Degree(body) == 0)
        {
            return false;
        }

        islands[_islands.Of(body)] = 1;
        return true;
    }
}

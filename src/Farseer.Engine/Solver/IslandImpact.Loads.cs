using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Islands;

namespace Farseer.Engine.Solver;

/// <content>What an island that was struck bears from now on.</content>
internal sealed unsafe partial class IslandImpact
{
    /// <summary>
    /// Gives the contacts of an island the impulses that bear it from now on: passes would take long to find how much heavier it has
    /// become. Friction is not solved for, so only islands of level contacts are given some.
    /// </summary>
    public void GiveLoads(
        int island, SmallIslands islands, BounceLanes* bounces, BodyStore bodies, Vector2 gravity, in ContactCoefficients c)
    {
        _system.Clear();
        for (int k = islands.First(island); k >= 0; k = islands[k].Next)
        {
            ref SmallIslandRow entry = ref islands[k];
            ContactBundle* row = entry.Row;
            int lane = entry.Lane;
            if (!Answers(row, lane))
            {
                continue;
            }

            FindGaps(row, lane, bodies, out double gap0, out double gap1);
            BounceLanes* bounce = entry.Bounce < 0 ? null : bounces + entry.Bounce;
            bool struck = bounce != null && ((bounce->Struck >> lane) & 1) != 0;
            bool touches0 = (Touches(&row->Point0, lane, gap0, c) || (struck && bounce->Point0.Pushed[lane] > 0))
                && Rests(row, lane, second: false, bodies, c);
            bool touches1 = (Touches(&row->Point1, lane, gap1, c) || (struck && bounce->Point1.Pushed[lane] > 0))
                && Rests(row, lane, second: true, bodies, c);
            if (!touches0 && !touches1)
            {
                continue;
            }

            if (!StartingLoads.IsLevel(row, lane, gravity, c.Gravity))
            {
                return;
            }

            if (touches0)
            {
                AddLoad(row, lane, second: false, bodies);
            }

            if (touches1)
            {
                AddLoad(row, lane, second: true, bodies);
            }
        }

        if (_system.Count > 0 && _system.Solve())
        {
            StartingLoads.Feed(_system);
        }
    }

    /// <summary>
    /// Neither parts nor approaches any more. What has bounced bears nothing: with a load its next impact would be left to the passes, and
    /// a box that struck both sides of a corner left it with up to a third more energy.
    /// </summary>
    private static bool Rests(ContactBundle* row, int lane, bool second, BodyStore bodies, in ContactCoefficients c)
    {
        Moment a = At(bodies, row->BodyA[lane], row->MassA[lane] + row->InertiaA[lane], 0, c);
        Moment b = At(bodies, row->BodyB[lane], row->MassB[lane] + row->InertiaB[lane], 0, c);
        ContactPointLanes* point = second ? &row->Point1 : &row->Point0;
        return Math.Abs(SpeedOf(row, lane, point, a, b, out _, out _)) <= BounceKernel.RestSubsteps * c.Gravity * c.Substep;
    }

    private void AddLoad(ContactBundle* row, int lane, bool second, BodyStore bodies)
    {
        ContactPointLanes* point = second ? &row->Point1 : &row->Point0;
        BodyDrive a = DriveOf(bodies, row->BodyA[lane], row->MassA[lane] + row->InertiaA[lane]);
        BodyDrive b = DriveOf(bodies, row->BodyB[lane], row->MassB[lane] + row->InertiaB[lane]);
        SystemPoint added = default;
        added.Bundle = row;
        added.Lane = lane;
        added.Second = second;
        added.ArmA = point->TangentArmA[lane];
        added.ArmB = point->TangentArmB[lane];
        added.Excess = ((double)row->NormalX[lane] * (b.X - a.X)) + ((double)row->NormalY[lane] * (b.Y - a.Y))
            + (b.W * added.ArmB) - (a.W * added.ArmA);
        _system.Add(added);
    }

    private static BodyDrive DriveOf(BodyStore bodies, int body, float answer) => answer > 0 ? bodies.Drive[body] : default;

    /// <summary>One of the bodies can move.</summary>
    private static bool Answers(ContactBundle* row, int lane) =>
        row->MassA[lane] + row->InertiaA[lane] + row->MassB[lane] + row->InertiaB[lane] > 0;
}

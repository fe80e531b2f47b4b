using System;
using System.Numerics;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Keeps the fat boxes around the pieces. A body that has moved less than its boxes allow costs a comparison; work is
/// proportional to what left its box.
/// </summary>
internal sealed unsafe class BoxStage
{
    /// <summary>A fat box is larger than the tight one by this share of the piece's extent, and by twice the step's motion.</summary>
    private const float MarginShare = 0.2f;
    private const float MotionShare = 2f;

    /// <summary>A margin this many times what a new box would get is given up.</summary>
    private const float Looseness = 2f;

    /// <summary>Contacts are kept up to this share of the extent apart; boxes must overlap before that.</summary>
    private const float SkinShare = 0.02f;

    /// <summary>A body that is foreseen to move by more than this share of its extent in a step is fast.</summary>
    private const float FastShare = 1f;

    /// <summary>2¹⁰⁰: at the edge of the floats' range a box must not become infinite, which the sorting of boxes cannot bear.</summary>
    private const float Farthest = 1.2676506e30f;

    private readonly Column<FitRecord> _fits = new Column<FitRecord>();

    public void Update(World world, float dt)
    {
        BodyStore bodies = world.Bodies;
        int end = bodies.Ids.End;
        _fits.EnsureCapacity(end);
        ulong* visited = bodies.Visited.Words;
        float pull = (Math.Abs(world.Settings.Gravity.X) + Math.Abs(world.Settings.Gravity.Y)) * dt;
        for (int body = 1; body < end; body++)
        {
            if (visited[body >> 6] == 0)
            {
                body |= 63;
                continue;
            }

            BodyFlags flags = bodies.Flags[body];
            const BodyFlags Moving = BodyFlags.Alive | BodyFlags.Enabled;
            bool moves = (flags & (Moving | BodyFlags.Static | BodyFlags.Asleep)) == Moving;
            if ((flags & BodyFlags.Moved) != 0)
            {
                bodies.Flags[body] = flags & ~(BodyFlags.Moved | BodyFlags.Fast);
                Fit(world, body, dt, pull);
                if (moves)
                {
                    NoteSpeed(bodies, body, Motion(bodies.State[body], bodies.Size[body].Reach, dt, pull));
                }
            }
            else if (moves)
            {
                float motion = Motion(bodies.State[body], _fits[body].Reach, dt, pull);
                if (HasLeft(bodies, body, motion) || IsLoose(bodies, body, motion))
                {
                    Fit(world, body, dt, pull);
                }

                NoteSpeed(bodies, body, motion);
            }
        }
    }

    private static void NoteSpeed(BodyStore bodies, int body, float motion)
    {
        BodyFlags flags = bodies.Flags[body];
        BodyFlags now = motion > bodies.Size[body].Extent ? flags | BodyFlags.Fast : flags & ~BodyFlags.Fast;
        if (now != flags)
        {
            bodies.Flags[body] = now;
        }
    }

    private bool HasLeft(BodyStore bodies, int body, float motion)
    {
        ref FitRecord fit = ref _fits[body];
        ref BodyPose pose = ref bodies.Pose[body];
        float travel = (float)(Math.Abs(pose.X - fit.X) + Math.Abs(pose.Y - fit.Y) + (Math.Abs(pose.Angle - fit.Angle) * fit.Reach));
        return !(travel + motion <= fit.Margin);
    }

    /// <summary>
    /// A body that was fast when it got its boxes and rests now would never leave them, and be paired with all around it for as long:
    /// pentagons that had fallen ten metres lay with twenty pairs each, of which two had points.
    /// </summary>
    private bool IsLoose(BodyStore bodies, int body, float motion) =>
        _fits[body].Margin > Looseness * (((MarginShare - SkinShare) * bodies.Size[body].Extent) + (MotionShare * motion));

    private static float Motion(in BodyState state, float reach, float dt, float pull) =>
        (Math.Abs(state.LinearVelocity.X) + Math.Abs(state.LinearVelocity.Y) + pull + (Math.Abs(state.AngularVelocity) * reach)) * dt;

    private void Fit(World world, int body, float dt, float pull)
    {
        ref BodyPose pose = ref world.Bodies.Pose[body];
        bool alive = (world.Bodies.Flags[body] & (BodyFlags.Alive | BodyFlags.Enabled)) == (BodyFlags.Alive | BodyFlags.Enabled);
        bool isStatic = (world.Bodies.Flags[body] & BodyFlags.Static) != 0;
        float margin = float.MaxValue;
        float reach = 0;
        float extent = float.MaxValue;
        for (int collider = world.FirstCollider(body); collider >= 0; collider = world.NextCollider(collider))
        {
            for (int piece = world.Shapes.Colliders[collider].FirstPiece; piece >= 0; piece = world.Shapes.NextPiece[piece])
            {
                float pieceReach = world.Shapes.Pieces[piece].Reach;
                float motion = isStatic ? 0 : Motion(world.Bodies.State[body], pieceReach, dt, pull);
                float size = world.Shapes.Pieces[piece].Extent;
                float spare = isStatic ? SkinShare * size : (MarginShare * size) + (MotionShare * motion);
                Box tight = world.Shapes.TightBox(piece, pose);
                spare = Math.Min(spare, Farthest);
                Expand(ref tight, spare);
                world.SetProxy(piece, tight, alive, isStatic);
                margin = Math.Min(margin, spare - (SkinShare * size));
                reach = Math.Max(reach, pieceReach);
                extent = Math.Min(extent, size);
            }
        }

        world.Bodies.Size[body] = new BodySize { Extent = FastShare * extent, Reach = reach };
        world.NoteSize(body, reach > 0 ? extent : 0, reach);
        _fits[body] = new FitRecord { X = pose.X, Y = pose.Y, Angle = pose.Angle, Reach = reach, Margin = margin };
    }

    private static void Expand(ref Box box, float spare)
    {
        box = Box.FromDouble((double)box.MinX - spare, (double)box.MinY - spare, (double)box.MaxX + spare, (double)box.MaxY + spare);
    }

    [StructLayout(LayoutKind.Sequential)]
    private struct FitRecord
    {
        public double X;
        public double Y;
        public double Angle;
        public float Reach;
        public float Margin;
    }
}

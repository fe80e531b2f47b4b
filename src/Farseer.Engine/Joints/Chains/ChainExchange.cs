using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Chains;

/// <summary>
/// To the records of the bodies, joints and trees, and from them: once a step, but for the steps in which somebody else looks at velocities
/// between the passes, or changes them.
/// </summary>
[NotState(Why.Fixed)]
internal sealed unsafe class ChainExchange : ChainPart
{
    public ChainExchange(ChainWork work)
        : base(work)
    {
    }

    /// <summary>Where the bodies are at the start of the step, and what their joints are off by.</summary>
    public void LoadPoses(Chain* chain)
    {
        ChainView view = _work.ViewOf(chain);
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        for (int i = chain->Front; i < chain->Bodies; i++)
        {
            LoadPose(view, i, places[i].Body);
        }

        // Of all bodies at once, and of what cannot move.
        double* angle = view[ChainColumn.Bent];
        bool anchored = chain->Joints == chain->Bodies;
        if (anchored)
        {
            LoadStill(chain, chain->Bodies, ref chain->StillAngle, out angle[chain->Bodies]);
        }

        for (int i = 0; i <= chain->Joints; i += StableMath.Lanes)
        {
            StableMath.SinCos(angle + i, view[ChainColumn.MiddleSin] + i, view[ChainColumn.MiddleCos] + i);
        }

        ChainPoses.Turn(view);
        ChainPoses.Place(view);
        chain->Swapped = !chain->Swapped;
        double* error = view[ChainColumn.Error];
        for (int i = 0; i < chain->Joints; i++)
        {
            double x = error[i];
            double y = error[view.Stride + i];
            _store.States[_work.Active[places[i].Active].Joint].Error = Math.Sqrt((x * x) + (y * y));
        }
    }

    private void LoadPose(in ChainView view, int at, int body)
    {
        int s = view.Stride;
        BodyState* state = _work.Step.Bodies.State.Pointer + body;
        BodyPose* pose = _work.Step.Bodies.Pose.Pointer + body;
        double* column = view.First + at;
        Put(column + ((int)ChainColumn.Move * s), s, state->DeltaPosition.X, state->DeltaPosition.Y, _work.Step.Bodies.Motion[body].Turned);
        Put(column + ((int)ChainColumn.Place * s), s, pose->X, pose->Y);
        column[(int)ChainColumn.Bent * s] = pose->Angle + _work.Step.Bodies.Drive[body].Lead;
    }

    public static void LoadAnchors(in ChainView view, int at, bool isHighB, in JointSettings settings)
    {
        int s = view.Stride;
        double* low = view[ChainColumn.LowAnchor] + at;
        double* high = low + (2 * s);
        Put(isHighB ? low : high, s, settings.AnchorAX, settings.AnchorAY);
        Put(isHighB ? high : low, s, settings.AnchorBX, settings.AnchorBY);
    }

    /// <summary>What a step begins with: from the records of bodies, nodes and joints.</summary>
    public void LoadPressed(Chain* chain)
    {
        ChainView view = _work.ViewOf(chain);
        int s = view.Stride;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        ChainWork.Clear(view[ChainColumn.Given], 4 * s);
        ChainWork.Clear(view[ChainColumn.Push], 7 * s);
        for (int i = chain->Front; i < chain->Bodies; i++)
        {
            TreeNode* node = _work.Forest.Nodes + places[i].Node;
            BodyPose* pose = _work.Step.Bodies.Pose.Pointer + places[i].Body;
            LoadMotion(view, i, places + i, false);
            Put(view[ChainColumn.Move] + i, s, node->Move[0], node->Move[1], node->Move[2]);
            Put(view[ChainColumn.Place] + i, s, pose->X, pose->Y);
            Put(view[ChainColumn.MiddleSin] + i, s, node->MiddleSin, node->MiddleCos);
            Put(view[ChainColumn.TurnSin] + i, s, node->TurnSin, node->TurnCos);
        }

        for (int i = 0; i < chain->Joints; i++)
        {
            ActiveJoint* joint = _work.Active + places[i].Active;
            double sign = places[i].IsHighB ? 1 : -1;
            Put(view[ChainColumn.Bend] + i, s, sign * joint->Bend[0], sign * joint->Bend[1]);
            Put(view[ChainColumn.Foreseen] + i, s, sign * joint->Foreseen[0], sign * joint->Foreseen[1]);
        }

        if (chain->Front > 0)
        {
            view[ChainColumn.TurnSin][0] = 0;
            view[ChainColumn.TurnCos][0] = 1;
        }

        if (chain->Joints == chain->Bodies)
        {
            view[ChainColumn.TurnSin][chain->Bodies] = 0;
            view[ChainColumn.TurnCos][chain->Bodies] = 1;
        }

        LoadStill(chain);
        if (chain->Front > 0 && LoadStill(chain, 0, ref chain->FrontAngle, out double angle))
        {
            TurnStill(chain, 0, angle);
        }

        ChainPoses.Place(view);
        chain->Swapped = !chain->Swapped;
    }

    public void LoadMotion(in ChainView view, int at, ChainPlace* place, bool hasVelocity)
    {
        int s = view.Stride;
        BodyState* state = _work.Step.Bodies.State.Pointer + place->Body;
        BodyDrive* drive = _work.Step.Bodies.Drive.Pointer + place->Body;
        BodyMass* mass = _work.Step.Bodies.Mass.Pointer + place->Body;
        double* column = view.First + at;
        double* velocity = column + ((int)ChainColumn.Velocity * s);
        if (!hasVelocity)
        {
            TreeNode* node = _work.Forest.Nodes + place->Node;
            Put(velocity, s, node->Velocity[0], node->Velocity[1], node->Velocity[2]);
        }

        Refresh(velocity, s, state);
        Put(column + ((int)ChainColumn.InverseMass * s), s, mass->InverseMass, mass->InverseInertia);
        Put(column + ((int)ChainColumn.LinearKeep * s), s, drive->LinearKeep, drive->AngularKeep);
        Put(column + ((int)ChainColumn.Drive * s), s, drive->X, drive->Y, drive->W);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Refresh(double* velocity, int s, BodyState* state)
    {
        velocity[0] = HeldVelocity.Refresh(velocity[0], state->LinearVelocity.X);
        velocity[s] = HeldVelocity.Refresh(velocity[s], state->LinearVelocity.Y);
        velocity[2 * s] = HeldVelocity.Refresh(velocity[2 * s], state->AngularVelocity);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Put(double* column, int s, double x, double y)
    {
        column[0] = x;
        column[s] = y;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Put(double* column, int s, double x, double y, double w)
    {
        column[0] = x;
        column[s] = y;
        column[2 * s] = w;
    }

    /// <summary>The pose of what the last joint holds on to.</summary>
    public void LoadStill(Chain* chain)
    {
        if (chain->Joints == chain->Bodies && LoadStill(chain, chain->Bodies, ref chain->StillAngle, out double angle))
        {
            TurnStill(chain, chain->Bodies, angle);
        }
    }

    private void TurnStill(Chain* chain, int at, double angle)
    {
        ChainView view = _work.ViewOf(chain);
        StableMath.SinCos(angle, out view[ChainColumn.MiddleSin][at], out view[ChainColumn.MiddleCos][at]);
    }

    /// <returns>True if its angle is another than it was.</returns>
    private bool LoadStill(Chain* chain, int at, ref double known, out double angle)
    {
        ChainView view = _work.ViewOf(chain);
        angle = TreesOnLanes.ReadStill(_work.Step.Bodies, _places[chain->PlaceFirst + at].Body, out double x, out double y);
        Put(view[ChainColumn.Place] + at, view.Stride, x, y);
        bool turned = angle != known;
        known = angle;
        return turned;
    }

    public void EnterWatched(Chain* chain, bool free)
    {
        ChainView view = _work.ViewOf(chain);
        int s = view.Stride;
        double* velocity = view[ChainColumn.Velocity];
        double* start = view[ChainColumn.StartVelocity];
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        for (int i = chain->Front; i < chain->Bodies; i++)
        {
            BodyState* state = _work.Step.Bodies.State.Pointer + places[i].Body;
            BodyMotion* motion = _work.Step.Bodies.Motion.Pointer + places[i].Body;
            BodyDrive* drive = _work.Step.Bodies.Drive.Pointer + places[i].Body;
            motion->ChangeX = 0;
            motion->ChangeY = 0;
            motion->ChangeW = 0;
            Put(start + i, s, motion->StartX, motion->StartY, motion->StartW);
            HeldVelocity.Drive(ref velocity[i], ref state->LinearVelocity.X, motion->StartX, drive->LinearKeep, drive->X);
            HeldVelocity.Drive(ref velocity[s + i], ref state->LinearVelocity.Y, motion->StartY, drive->LinearKeep, drive->Y);
            HeldVelocity.Drive(ref velocity[(2 * s) + i], ref state->AngularVelocity, motion->StartW, drive->AngularKeep, drive->W);
            if (free)
            {
                HeldVelocity.Kick(ref velocity[i], ref state->LinearVelocity.X, -0.5 * drive->X);
                HeldVelocity.Kick(ref velocity[s + i], ref state->LinearVelocity.Y, -0.5 * drive->Y);
                HeldVelocity.Kick(ref velocity[(2 * s) + i], ref state->AngularVelocity, -0.5 * drive->W);
            }
        }
    }

    /// <summary>The velocities in double stand as long as the store has their rounding.</summary>
    public void Refresh(Chain* chain)
    {
        ChainView view = _work.ViewOf(chain);
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        for (int i = chain->Front; i < chain->Bodies; i++)
        {
            Refresh(view[ChainColumn.Velocity] + i, view.Stride, _work.Step.Bodies.State.Pointer + places[i].Body);
        }
    }

    public void StoreVelocities(Chain* chain)
    {
        ChainView view = _work.ViewOf(chain);
        int s = view.Stride;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        for (int i = chain->Front; i < chain->Bodies; i++)
        {
            BodyState* state = _work.Step.Bodies.State.Pointer + places[i].Body;
            double* v = view[ChainColumn.Velocity] + i;
            state->LinearVelocity.X = (float)v[0];
            state->LinearVelocity.Y = (float)v[s];
            state->AngularVelocity = (float)v[2 * s];
        }
    }

    public void StoreMoves(Chain* chain)
    {
        ChainView view = _work.ViewOf(chain);
        int s = view.Stride;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        for (int i = chain->Front; i < chain->Bodies; i++)
        {
            BodyState* state = _work.Step.Bodies.State.Pointer + places[i].Body;
            double* move = view[ChainColumn.Move] + i;
            state->DeltaPosition.X = (float)move[0];
            state->DeltaPosition.Y = (float)move[s];
            _work.Step.Bodies.Motion[places[i].Body].Turned = (float)move[2 * s];
            Integrator.Show(state, move[2 * s], view[ChainColumn.TurnSin][i], view[ChainColumn.TurnCos][i]);
        }
    }

    /// <summary>What the store would have noted of the substep, had it been told of the velocities in between.</summary>
    private void StoreStart(Chain* chain)
    {
        ChainView view = _work.ViewOf(chain);
        int s = view.Stride;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        for (int i = chain->Front; i < chain->Bodies; i++)
        {
            BodyMotion* motion = _work.Step.Bodies.Motion.Pointer + places[i].Body;
            double* start = view[ChainColumn.StartVelocity] + i;
            motion->StartX = (float)start[0];
            motion->StartY = (float)start[s];
            motion->StartW = (float)start[2 * s];
            motion->ChangeX = 0;
            motion->ChangeY = 0;
            motion->ChangeW = 0;
        }
    }

    /// <param name="chain">The chain that is given back.</param>
    /// <param name="before">As it is; else its correction went astray, and what it was before is told as well.</param>
    public void Leave(Chain* chain, bool before)
    {
        ChainView view = _work.ViewOf(chain);
        int s = view.Stride;
        JointTree* tree = _work.Forest.Trees + chain->Tree;
        tree->IsQuiet = false;
        tree->OnChain = false;
        tree->Exact = true;
        tree->Disturbed = false;
        tree->Corrects = false;
        tree->Refactored = false;
        tree->Astray = !before;
        tree->Worst = chain->Worst;
        tree->Before = chain->Before;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        for (int i = chain->Front; i < chain->Bodies; i++)
        {
            TreeNode* node = _work.Forest.Nodes + places[i].Node;
            PutBack(view[ChainColumn.Move] + i, s, node->Move);
            PutBack(view[ChainColumn.StartMove] + i, s, node->StartMove);
            PutBack(view[before ? ChainColumn.Move : ChainColumn.PlainMove] + i, s, node->PlainMove);
            PutBack(view[before ? ChainColumn.Velocity : ChainColumn.PlainVelocity] + i, s, node->PlainVelocity);
            node->Bent = view[ChainColumn.Bent][i];
            node->MiddleSin = view[ChainColumn.MiddleSin][i];
            node->MiddleCos = view[ChainColumn.MiddleCos][i];
            node->TurnSin = view[ChainColumn.TurnSin][i];
            node->TurnCos = view[ChainColumn.TurnCos][i];
            node->InverseMass = view[ChainColumn.InverseMass][i];
            node->InverseInertia = view[ChainColumn.InverseInertia][i];
        }

        for (int i = 0; i < chain->Joints; i++)
        {
            ActiveJoint* joint = _work.Active + places[i].Active;
            PutGiven(view[ChainColumn.Given] + i, s, places[i].IsHighB, joint->Given);
            joint->GivenBefore[0] = joint->Given[0];
            joint->GivenBefore[1] = joint->Given[1];
            PutGiven(view[before ? ChainColumn.Given : ChainColumn.PlainGiven] + i, s, places[i].IsHighB, joint->PlainGiven);
        }

        StoreVelocities(chain);
        StoreStart(chain);
        if (chain->IsPressed)
        {
            StoreMoves(chain);
            GiveBends(chain);
            chain->HasVelocities = true;
        }

        GiveVelocities(chain);
        _work.AllStay = false;
        chain->IsPressed = false;
        chain->IsLive = false;
        if (!FloatBits.IsFinite(chain->Worst))
        {
            // What is no number may have got to where nothing is.
            _work.ClearNumbers(chain);
        }

        _work.GivenTrees[_work.GivenCount++] = chain->Tree;
    }

    /// <summary>The velocities in double to the nodes, which are solved elsewhere.</summary>
    public void GiveVelocities(Chain* chain)
    {
        ChainView view = _work.ViewOf(chain);
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        for (int i = chain->Front; i < chain->Bodies && chain->HasVelocities; i++)
        {
            PutBack(view[ChainColumn.Velocity] + i, view.Stride, _work.Forest.Nodes[places[i].Node].Velocity);
        }

        chain->HasVelocities = false;
    }

    public void GiveBends(Chain* chain)
    {
        ChainView view = _work.ViewOf(chain);
        int s = view.Stride;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        for (int i = 0; i < chain->Joints; i++)
        {
            ActiveJoint* joint = _work.Active + places[i].Active;
            double sign = places[i].IsHighB ? 1 : -1;
            for (int r = 0; r < 2; r++)
            {
                joint->Bend[r] = sign * view[ChainColumn.Bend][i + (r * s)];
                joint->Foreseen[r] = sign * view[ChainColumn.Foreseen][i + (r * s)];
            }
        }
    }

    /// <summary>All that a step leaves.</summary>
    public void KeepAll(Chain* chain)
    {
        StoreVelocities(chain);
        StoreMoves(chain);
        StoreStart(chain);
        KeepMoves(chain);
        StoreForces(chain);
    }

    /// <summary>
    /// What the floats of the displacements leave out of the step goes into the poses directly: see <see cref="JointSolver"/>.
    /// </summary>
    private void KeepMoves(Chain* chain)
    {
        double held = TreeBodies.HeldShare * _work.Step.Substep;
        ChainView view = _work.ViewOf(chain);
        int s = view.Stride;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        for (int i = chain->Front; i < chain->Bodies; i++)
        {
            double* move = view[ChainColumn.Move] + i;
            double* drive = view[ChainColumn.Drive] + i;
            BodyState* state = _work.Step.Bodies.State.Pointer + places[i].Body;
            BodyPose* pose = _work.Step.Bodies.Pose.Pointer + places[i].Body;
            ref float turned = ref _work.Step.Bodies.Motion[places[i].Body].Turned;
            pose->X += TreeBodies.Kept(move[0], held * drive[0], ref state->DeltaPosition.X);
            pose->Y += TreeBodies.Kept(move[s], held * drive[s], ref state->DeltaPosition.Y);
            pose->Angle += TreeBodies.Kept(move[2 * s], held * drive[2 * s], ref turned);
        }
    }

    private void StoreForces(Chain* chain)
    {
        ChainView view = _work.ViewOf(chain);
        int s = view.Stride;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        double* given = stackalloc double[3];
        double perStep = 1 / _work.Step.Dt;
        for (int i = 0; i < chain->Joints; i++)
        {
            ref JointState state = ref _store.States[_work.Active[places[i].Active].Joint];
            PutGiven(view[ChainColumn.Given] + i, s, places[i].IsHighB, given);
            double* arm = view[view.Arms] + (places[i].IsHighB ? 2 * s : 0) + i;
            state.Impulse[0] = 0;
            state.Impulse[1] = 0;
            state.ForceX = given[0] * perStep;
            state.ForceY = given[1] * perStep;
            state.Torque = (given[2] - ((arm[0] * given[1]) - (arm[s] * given[0]))) * perStep;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void PutBack(double* column, int s, double* to)
    {
        to[0] = column[0];
        to[1] = column[s];
        to[2] = column[2 * s];
    }

    /// <summary>What a joint gave to its body B; the moment about the high body stands one place further on.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void PutGiven(double* column, int s, bool isHighB, double* to)
    {
        double sign = isHighB ? 1 : -1;
        to[0] = sign * column[0];
        to[1] = sign * column[s];
        to[2] = sign * (isHighB ? column[(3 * s) + 1] : column[2 * s]);
    }
}

using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Lanes;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Loose;

/// <summary>
/// Joints without hard rows between bodies that no tree holds: soft joints, springs, motors, targets, and limits. They are iterated, four
/// side by side: of the rows in their order those that share no body with one before them go first, then those that share one only with
/// these, and so on. So each gives the bits that it gives in turn, in a chain, a net or by itself. Their bodies are kept in records of
/// 200 bytes meanwhile, and no other pass of <see cref="JointSolver"/> sees them.
/// </summary>
internal sealed unsafe partial class LooseSolver
{
    private readonly Column<LooseBody> _bodies = new Column<LooseBody>();
    private readonly Column<LooseBundle> _bundles = new Column<LooseBundle>();
    private readonly Column<LoosePlace> _places = new Column<LoosePlace>();
    private readonly Column<LooseRow> _looseRows = new Column<LooseRow>();
    private readonly TurnTable _turns = new TurnTable();
    [NotState(Why.Elsewhere)]
    private JointForest _forest = null!;
    private ActiveJoint* _active;
    private JointRows* _rows;
    private JointStep _step;
    private int _bodyCount;
    private int _bundleCount;
    private int _rowCount;
    private int _jointCount;

    public bool Any => _jointCount > 0;

    /// <summary>Joints and bodies that were taken; of a body that cannot move the node is -1.</summary>
    public int JointCount => _jointCount;

    public int BodyCount => _bodyCount;

    public int JointAt(int index) => _items[index];

    public int NodeAt(int index) => index == Nobody ? -1 : _bodies[index].Node;

    /// <summary>The velocities in double stand as long as the store has their rounding.</summary>
    public void Refresh()
    {
        BodyState* states = _step.Bodies.State.Pointer;
        for (int i = Nobody + 1; i < _bodyCount; i++)
        {
            LooseBody* body = _bodies.Pointer + i;
            Refresh(body, states + body->Body);
        }
    }

    private static void Refresh(LooseBody* body, BodyState* state)
    {
        bool moves = body->Node >= 0;
        body->Velocity[0] = moves ? HeldVelocity.Refresh(body->Velocity[0], state->LinearVelocity.X) : state->LinearVelocity.X;
        body->Velocity[1] = moves ? HeldVelocity.Refresh(body->Velocity[1], state->LinearVelocity.Y) : state->LinearVelocity.Y;
        body->Velocity[2] = moves ? HeldVelocity.Refresh(body->Velocity[2], state->AngularVelocity) : state->AngularVelocity;
    }

    /// <summary>See <see cref="JointSolver.Enter"/>.</summary>
    public void Enter()
    {
        MarkExact();
        Foresee();
        BodyState* states = _step.Bodies.State.Pointer;
        for (int i = Nobody + 1; i < _bodyCount; i++)
        {
            LooseBody* body = _bodies.Pointer + i;
            BodyState* state = states + body->Body;
            if (body->Node >= 0)
            {
                BodyMotion* motion = _step.Bodies.Motion.Pointer + body->Body;
                BodyDrive* drive = _step.Bodies.Drive.Pointer + body->Body;
                if (body->Exact)
                {
                    motion->ChangeX = 0;
                    motion->ChangeY = 0;
                    motion->ChangeW = 0;
                }

                HeldVelocity.Drive(ref body->Velocity[0], ref state->LinearVelocity.X, motion->StartX, drive->LinearKeep, drive->X);
                HeldVelocity.Drive(ref body->Velocity[1], ref state->LinearVelocity.Y, motion->StartY, drive->LinearKeep, drive->Y);
                HeldVelocity.Drive(ref body->Velocity[2], ref state->AngularVelocity, motion->StartW, drive->AngularKeep, drive->W);
                Kick(body, state, -0.5f);
            }

            Refresh(body, state);
        }

        for (int i = 0; i < _bundleCount; i++)
        {
            LoosePlace* place = _places.Pointer + i;
            LooseKernel.WarmStart(_bundles.Pointer + i, _looseRows.Pointer + place->FirstRow, place, _bodies.Pointer);
        }

        StoreVelocities();
    }

    /// <summary>See <see cref="JointPass.Foresee"/>.</summary>
    private void Foresee()
    {
        for (int i = 0; i < _bundleCount; i++)
        {
            LoosePlace* place = _places.Pointer + i;
            for (int k = 0; k < place->Rows; k++)
            {
                for (int lane = 0; lane < place->Count && place->Type[k] == (byte)RowType.Spring; lane++)
                {
                    LaneSoftRow* row = &DoubleLanes.Shift(_looseRows.Pointer + place->FirstRow + k, lane)->Soft;
                    double speed =
                        StartSpeed(_bodies.Pointer + place->BodyA[lane], row->A) + StartSpeed(_bodies.Pointer + place->BodyB[lane], row->B);
                    row->Ahead[0] = row->Lead[0] * speed;
                }
            }
        }
    }

    private double StartSpeed(LooseBody* body, double* j) =>
        HeldVelocity.StartSpeed(_step.Bodies, body->Body, body->Node >= 0, body->Velocity, 1, j, Y);

    /// <summary>
    /// Bodies that have half of their forces before they move, that something other than limits holds, or a limit that pushes.
    /// </summary>
    private void MarkExact()
    {
        for (int i = Nobody + 1; i < _bodyCount; i++)
        {
            _bodies[i].Exact = (_bodies[i].Held || _bodies[i].Free) && _bodies[i].Node >= 0;
        }

        for (int i = 0; i < _bundleCount; i++)
        {
            LoosePlace* place = _places.Pointer + i;
            for (int lane = 0; lane < place->Count && place->OnlyLimits; lane++)
            {
                bool acts = false;
                for (int k = 0; k < place->Rows; k++)
                {
                    acts |= _looseRows.Pointer[place->FirstRow + k].Soft.Lambda[lane] > 0;
                }

                _bodies[place->IntoA[lane]].Exact |= acts;
                _bodies[place->IntoB[lane]].Exact |= acts;
            }
        }
    }

    private void Kick(LooseBody* body, BodyState* state, float share)
    {
        if (body->Free)
        {
            BodyDrive* drive = _step.Bodies.Drive.Pointer + body->Body;
            HeldVelocity.Kick(ref body->Velocity[0], ref state->LinearVelocity.X, share * (double)drive->X);
            HeldVelocity.Kick(ref body->Velocity[1], ref state->LinearVelocity.Y, share * (double)drive->Y);
            HeldVelocity.Kick(ref body->Velocity[2], ref state->AngularVelocity, share * (double)drive->W);
        }
    }

    /// <summary>The biased pass or the relax pass.</summary>
    /// <param name="biased">Which of the two.</param>
    /// <param name="sweeps">How often.</param>
    /// <param name="wishes">Over the joints that are not of limits alone.</param>
    /// <param name="limits">Over those that are.</param>
    public void Solve(bool biased, int sweeps, bool wishes, bool limits)
    {
        Refresh();
        for (int sweep = 0; sweep < sweeps; sweep++)
        {
            for (int i = 0; i < _bundleCount; i++)
            {
                LoosePlace* place = _places.Pointer + i;
                if (!(place->OnlyLimits ? limits : wishes))
                {
                    continue;
                }

                LooseRow* rows = _looseRows.Pointer + place->FirstRow;
                LooseKernel.Solve(_bundles.Pointer + i, rows, place, _bodies.Pointer, _step.Pace, biased);
            }
        }

        StoreVelocities();
    }

    /// <summary>Exact bodies move by h·v in double; the others have been moved. See <see cref="TreePositions.CorrectPositions"/>.</summary>
    /// <param name="pushed">The store has also moved bodies by velocities that push them apart.</param>
    public void Move(bool pushed)
    {
        Refresh();
        double h = _step.Substep;
        _turns.Clear(_bodyCount);
        for (int i = Nobody + 1; i < _bodyCount; i++)
        {
            LooseBody* body = _bodies.Pointer + i;
            if (body->Node >= 0 && body->Exact)
            {
                LoosePush push = pushed && body->Held ? LoosePush.Of(_step, body->Body, body->Move) : default;
                body->Move[0] += (h * body->Velocity[0]) + push.X;
                body->Move[1] += (h * body->Velocity[1]) + push.Y;
                body->Move[2] += (h * body->Velocity[2]) + push.Turn;
            }
            else if (body->Node >= 0)
            {
                BodyState* state = _step.Bodies.State.Pointer + body->Body;
                body->Move[0] = state->DeltaPosition.X;
                body->Move[1] = state->DeltaPosition.Y;
                body->Move[2] = _step.Bodies.Motion[body->Body].Turned;
            }

            _turns.Add(body->Move[2]);
        }

        _turns.Find();
        for (int i = Nobody + 1; i < _bodyCount; i++)
        {
            LooseBody* body = _bodies.Pointer + i;
            body->TurnSin = _turns.Sin(i - Nobody - 1);
            body->TurnCos = _turns.Cos(i - Nobody - 1);
            if (body->Exact)
            {
                StoreMove(body);
            }
        }
    }

    /// <summary>All are told where they are, since displacements of others count for every tree with rows.</summary>
    public void StoreMoves()
    {
        for (int i = Nobody + 1; i < _bodyCount; i++)
        {
            if (_bodies[i].Node >= 0)
            {
                StoreMove(_bodies.Pointer + i);
            }
        }
    }

    private void StoreMove(LooseBody* body)
    {
        BodyState* state = _step.Bodies.State.Pointer + body->Body;
        state->DeltaPosition.X = (float)body->Move[0];
        state->DeltaPosition.Y = (float)body->Move[1];
        _step.Bodies.Motion[body->Body].Turned = (float)body->Move[2];
        Integrator.Show(state, body->Move[2], body->TurnSin, body->TurnCos);
    }

    /// <summary>The rows where the bodies stand, and the other half of what free ones take.</summary>
    public void EndPositions()
    {
        for (int i = Nobody + 1; i < _bodyCount; i++)
        {
            FindPose(_bodies.Pointer + i);
        }

        for (int i = 0; i < _bundleCount; i++)
        {
            LoosePlace* place = _places.Pointer + i;
            LooseForms.Write(_bundles.Pointer + i, _looseRows.Pointer + place->FirstRow, place, _bodies.Pointer);
            Prepare(i);
        }

        for (int i = Nobody + 1; i < _bodyCount; i++)
        {
            LooseBody* body = _bodies.Pointer + i;
            Kick(body, _step.Bodies.State.Pointer + body->Body, 0.5f);
        }

        for (int i = 0; i < _bundleCount; i++)
        {
            LoosePlace* place = _places.Pointer + i;
            LooseKernel.Resume(_bundles.Pointer + i, _looseRows.Pointer + place->FirstRow, place, _bodies.Pointer);
        }

        StoreVelocities(freeOnly: true);
    }

    private void Prepare(int bundle)
    {
        LoosePlace* place = _places.Pointer + bundle;
        LooseKernel.Prepare(_bundles.Pointer + bundle, _looseRows.Pointer + place->FirstRow, place, _step.Substep);
    }

    private void FindPose(LooseBody* body)
    {
        if (body->Node >= 0)
        {
            body->Pose[0] = body->StartX + body->Move[0];
            body->Pose[1] = body->StartY + body->Move[1];
            body->Pose[2] = body->StartAngle + (body->Move[2] + body->Lead);
            body->Pose[3] = (body->MiddleCos * body->TurnCos) - (body->MiddleSin * body->TurnSin);
            body->Pose[4] = (body->MiddleSin * body->TurnCos) + (body->MiddleCos * body->TurnSin);
            return;
        }

        double angle = TreesOnLanes.ReadStill(_step.Bodies, body->Body, out body->Pose[0], out body->Pose[1]);
        if (angle != body->Pose[2])
        {
            body->Pose[2] = angle;
            StableMath.SinCos(angle, out body->Pose[4], out body->Pose[3]);
        }
    }

    private void StoreVelocities(bool freeOnly = false)
    {
        for (int i = Nobody + 1; i < _bodyCount; i++)
        {
            LooseBody* body = _bodies.Pointer + i;
            if (body->Node >= 0 && (body->Free || !freeOnly))
            {
                TreeBodies.StoreVelocity(body->Velocity, _step.Bodies.State.Pointer + body->Body);
            }
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_placeOf);
        s.Column(_levels);
        s.Column(_keys);
        s.Column(_items);
        s.Local(_bodies);
        s.Local(_bundles);
        s.Column(_places);
        s.Local(_looseRows);
        _turns.Visit(s);
        s.Value(ref _bodyCount);
        s.Value(ref _bundleCount);
        s.Value(ref _rowCount);
        s.Value(ref _jointCount);
    }
}

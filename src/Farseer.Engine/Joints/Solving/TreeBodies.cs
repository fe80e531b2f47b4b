using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Loose;
using Farseer.Engine.Joints.Nets;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>Masses, poses and velocities: from the store and back.</summary>
internal sealed unsafe partial class TreeBodies : JointPart
{
    /// <summary>Rounding of a way that joints hold, as a share of what the force alone would give: 256 last places of a double.</summary>
    internal const double HeldShare = 5.6843418860808015e-14;

    private const int MeshRounds = 2;
    private readonly TurnTable _turns = new TurnTable();
    private readonly Column<int> _moved = new Column<int>();

    public TreeBodies(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    public void LoadMasses()
    {
        for (int at = 0; at < _work.NodeCount; at++)
        {
            int i = _nodes[at];
            LoadMass(_forest.Nodes + i);
        }
    }

    public void LoadMass(TreeNode* node)
    {
        ref BodyMass mass = ref _work.Step.Bodies.Mass[node->Body];
        node->InverseMass = mass.InverseMass;
        node->InverseInertia = mass.InverseInertia;
    }

    /// <summary>
    /// Trees that touch nothing and that nothing springy pulls at are free, if that holds for all to which rows tie them: a rope or a motor
    /// gives both of its bodies one impulse, so both are to have had the same share of their forces. The bodies of nets are for
    /// <see cref="NetBodies"/> to see to.
    /// </summary>
    public void MarkFree()
    {
        _nets.Release();
        for (int at = 0; at < _work.TreeCount; at++)
        {
            _forest.Trees[_trees[at]].Free = true;
        }

        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (tree->Pulled || tree->Strung)
            {
                Bind(tree->First);
            }
        }

        for (int at = 0; at < _work.NodeCount; at++)
        {
            int i = _nodes[at];
            int body = _forest.Nodes[i].Body;
            if (_work.Step.Touches[body] > 0 || _nets.Search.IsNet(body))
            {
                Bind(i);
            }
        }

        for (int at = 0; at < _work.JointCount; at++)
        {
            int i = _joints[at];
            if (GivesWay(_active.Pointer + i, _rows.Pointer + i))
            {
                Bind(_active[i].Ends.NodeA);
                Bind(_active[i].Ends.NodeB);
            }

            if (Acts(_active.Pointer + i, _rows.Pointer + i))
            {
                _nets.Bind(_active[i].Ends.BodyA);
                _nets.Bind(_active[i].Ends.BodyB);
            }
        }

        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            tree->Free = _forest.GroupOf(tree)->Free;
        }
    }

    private void Bind(int node)
    {
        if (node >= 0)
        {
            _forest.GroupOf(_forest.Trees + _forest.Nodes[node].Tree)->Free = false;
        }
    }

    /// <summary>
    /// A spring, or a motor or limit that yields to its impulse, gives all of it before the move: how far it yields goes by the impulse of
    /// the whole substep.
    /// </summary>
    private static bool GivesWay(ActiveJoint* joint, JointRows* rows)
    {
        bool gives = false;
        for (int k = rows->Hard; k < rows->Count; k++)
        {
            gives |= (RowType)rows->Type[k] switch
            {
                RowType.Motor => rows->Damping[k] > 0 || rows->Share[k] < 1,
                RowType.Limit => rows->Damping[k] > 0 && joint->Lambda[k] > 0,
                _ => true,
            };
        }

        return gives;
    }

    /// <summary>It has a motor or a spring, or a limit that holds.</summary>
    private static bool Acts(ActiveJoint* joint, JointRows* rows)
    {
        for (int k = rows->Hard; k < rows->Count; k++)
        {
            if (rows->Type[k] != (byte)RowType.Limit || joint->Lambda[k] > 0)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>
    /// A free tree takes half of its gravity and forces before it moves and half after, which is exact to the second order, and under a
    /// constant force altogether: x₁ = x₀ + h·(v₀ + ½h·a). The solver has given all of it before. With contacts that would load them with
    /// half the weight in turn. Its motors and limits do the same, see <see cref="JointPass.Resume"/>.
    /// </summary>
    public void Kick(float share)
    {
        BodyState* states = _work.Step.Bodies.State.Pointer;
        BodyDrive* drives = _work.Step.Bodies.Drive.Pointer;
        for (int at = 0; at < _work.NodeCount; at++)
        {
            int i = _nodes[at];
            TreeNode* node = _forest.Nodes + i;
            if (_forest.Trees[node->Tree].Free)
            {
                BodyState* state = states + node->Body;
                BodyDrive* drive = drives + node->Body;
                HeldVelocity.Kick(ref node->Velocity[0], ref state->LinearVelocity.X, share * (double)drive->X);
                HeldVelocity.Kick(ref node->Velocity[1], ref state->LinearVelocity.Y, share * (double)drive->Y);
                HeldVelocity.Kick(ref node->Velocity[2], ref state->AngularVelocity, share * (double)drive->W);
            }
        }
    }

    /// <summary>
    /// Trees whose bodies nothing else moves, and those that have had half of their forces: the law for steady acceleration would take a
    /// quarter of them for what is too much. A guest is one as long as it presses on a tree: then the two must move by the same law,
    /// or their surfaces part by half of g·h² in each substep. If deep overlaps are pushed apart, guests move with them.
    /// </summary>
    public void MarkExact()
    {
        for (int at = 0; at < _work.TreeCount; at++)
        {
            int i = _trees[at];
            _forest.Trees[i].Exact = _forest.Trees[i].Eliminates || _forest.Trees[i].Free;
        }

        // Iterated joints tie their bodies as well: moved by laws that differ by g·h² they would be pulled askew. And a force that
        // turns with its bodies is not the steady one that the exact law is for: a pair that whirls at the end of its rope would gain
        // the share ωh/2 of the rope's force along its way, and tear off within seconds.
        for (int at = 0; at < _work.JointCount; at++)
        {
            int i = _joints[at];
            if (_active[i].Role == JointRole.Iterated && (_rows[i].Hard > 0 || Acts(_active.Pointer + i, _rows.Pointer + i)))
            {
                MarkExact(_active[i].Ends.NodeA);
                MarkExact(_active[i].Ends.NodeB);
            }
        }

        for (int i = 0; i < _work.ContactCount; i++)
        {
            ref TreeContact contact = ref _contacts[i];
            if (!contact.Deep && (contact.Point0.Normal > 0 || contact.Point1.Normal > 0))
            {
                MarkExact(contact.Ends.NodeA);
                MarkExact(contact.Ends.NodeB);
            }
        }
    }

    public void MarkExact(int node)
    {
        if (node >= 0)
        {
            _forest.Trees[_forest.Nodes[node].Tree].Exact = true;
        }
    }

    /// <summary>The displacements, as they stand in the store.</summary>
    /// <param name="first">Of the nodes that take part, the first that is loaded.</param>
    public void LoadMoves(int first)
    {
        _turns.Clear(2 * _nodes.Capacity);
        for (int at = first; at < _work.NodeCount; at++)
        {
            TreeNode* node = _forest.Nodes + _nodes[at];
            double middle = _work.Step.Bodies.Pose[node->Body].Angle + _work.Step.Bodies.Drive[node->Body].Lead;
            ReadMove(node);
            _turns.Add(middle);
            _turns.Add(node->Move[2]);
        }

        _turns.Find();
        for (int at = first, k = 0; at < _work.NodeCount; at++, k += 2)
        {
            TreeNode* node = _forest.Nodes + _nodes[at];
            node->MiddleSin = _turns.Sin(k);
            node->MiddleCos = _turns.Cos(k);
            node->TurnSin = _turns.Sin(k + 1);
            node->TurnCos = _turns.Cos(k + 1);
        }
    }

    public void LoadMove(TreeNode* node)
    {
        ReadMove(node);
        StableMath.SinCos(node->Move[2], out node->TurnSin, out node->TurnCos);
    }

    private void ReadMove(TreeNode* node)
    {
        _work.Posed = false;
        BodyState* state = _work.Step.Bodies.State.Pointer + node->Body;
        node->Move[0] = state->DeltaPosition.X;
        node->Move[1] = state->DeltaPosition.Y;
        node->Move[2] = _work.Step.Bodies.Motion[node->Body].Turned;
    }

    public void SetMove(TreeNode* node, double x, double y, double turned)
    {
        _work.Posed = false;
        node->Move[0] = x;
        node->Move[1] = y;
        node->Move[2] = turned;
        StableMath.SinCos(turned, out node->TurnSin, out node->TurnCos);
        StoreMove(node);
    }

    /// <summary>
    /// Moves a body by what its velocity does in a substep, turned by a radian at most: further off a joint's direction tells nothing.
    /// </summary>
    public void MoveOn(TreeNode* node)
    {
        double h = _work.Step.Substep;
        double* v = node->Velocity;
        double turn = Math.Max(-1, Math.Min(1, h * v[2]));
        SetMove(node, node->Move[0] + (h * v[0]), node->Move[1] + (h * v[1]), node->Move[2] + turn);
    }

    /// <summary>As <see cref="SetMove"/>, with sines and cosines found together: <see cref="StoreMoves"/> must follow.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void NoteMove(int index, double x, double y, double turned)
    {
        TreeNode* node = _forest.Nodes + index;
        node->Move[0] = x;
        node->Move[1] = y;
        node->Move[2] = turned;
        _moved[_turns.Count] = index;
        _turns.Add(turned);
    }

    public void ClearMoves()
    {
        _work.Posed = false;
        _turns.Clear(_nodes.Capacity);
        _moved.EnsureCapacity(_nodes.Capacity);
    }

    public void StoreMoves()
    {
        _turns.Find();
        TreeNode* nodes = _forest.Nodes;
        BodyState* states = _work.Step.Bodies.State.Pointer;
        BodyMotion* motions = _work.Step.Bodies.Motion.Pointer;
        int count = _turns.Count;
        for (int k = 0; k < count; k++)
        {
            TreeNode* node = nodes + _moved[k];
            node->TurnSin = _turns.Sin(k);
            node->TurnCos = _turns.Cos(k);
            StoreMove(node, states + node->Body, motions + node->Body);
        }
    }

    private void StoreMove(TreeNode* node) =>
        StoreMove(node, _work.Step.Bodies.State.Pointer + node->Body, _work.Step.Bodies.Motion.Pointer + node->Body);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void StoreMove(TreeNode* node, BodyState* state, BodyMotion* motion)
    {
        state->DeltaPosition.X = (float)node->Move[0];
        state->DeltaPosition.Y = (float)node->Move[1];
        motion->Turned = (float)node->Move[2];
        Integrator.Show(state, node->Move[2], node->TurnSin, node->TurnCos);
    }

    /// <summary>What the floats of the displacements leave out of the step goes into the poses directly.</summary>
    public void KeepMoves()
    {
        double held = HeldShare * _work.Step.Substep;
        for (int at = 0; at < _work.NodeCount; at++)
        {
            int i = _nodes[at];
            TreeNode* node = _forest.Nodes + i;
            BodyState* state = _work.Step.Bodies.State.Pointer + node->Body;
            BodyDrive* drive = _work.Step.Bodies.Drive.Pointer + node->Body;
            ref BodyPose pose = ref _work.Step.Bodies.Pose[node->Body];
            ref float turned = ref _work.Step.Bodies.Motion[node->Body].Turned;
            pose.X += Kept(node->Move[0], held * drive->X, ref state->DeltaPosition.X);
            pose.Y += Kept(node->Move[1], held * drive->Y, ref state->DeltaPosition.Y);
            pose.Angle += Kept(node->Move[2], held * drive->W, ref turned);
        }
    }

    /// <summary>
    /// Meshing gears end a step in their ratio to the last bit, or the next: what the rounding of their bodies' speeds left of it goes to
    /// body B. Two rounds, for the first is rounded itself.
    /// </summary>
    public void Mesh(ActiveJoint* joint)
    {
        int b = joint->Ends.NodeB;
        if (b < 0)
        {
            return;
        }

        for (int round = 0; round < MeshRounds; round++)
        {
            double angleA = joint->Settings.Ratio * EndAngle(joint->Ends.NodeA, joint->Ends.BodyA);
            double angleB = EndAngle(b, joint->Ends.BodyB);
            double error = angleB + angleA - joint->Settings.Target;
            if (Math.Abs(error) <= HeldShare * (Math.Abs(angleA) + Math.Abs(angleB)))
            {
                _forest.Nodes[b].Move[2] -= error;
            }
        }
    }

    /// <summary>The angle that a body is going to have, rounded as the end of the step rounds it.</summary>
    private double EndAngle(int node, int body)
    {
        if (node < 0)
        {
            return TreesOnLanes.ReadStill(_work.Step.Bodies, body, out _, out _);
        }

        double turned = _work.Step.Bodies.Motion[body].Turned;
        return _work.Step.Bodies.Pose[body].Angle + (_forest.Nodes[node].Move[2] - turned) + (turned + _work.Step.Bodies.Drive[body].Lead);
    }

    /// <summary>
    /// What a float leaves out of a way. A way that is no more than the rounding of a force and of the joints that hold it is none: a body
    /// that stands on its line stays there to the last bit.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static double Kept(double way, double rounding, ref float stored)
    {
        if (Math.Abs(way) <= Math.Abs(rounding))
        {
            stored = 0;
            return 0;
        }

        return way - stored;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _turns.Visit(s);
        s.Column(_moved);
    }
}

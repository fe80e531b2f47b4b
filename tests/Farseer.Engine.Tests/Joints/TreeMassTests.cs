using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Joints.Nets;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Joints;

/// <summary>The elimination along a tree and the lazy walk against the dense Schur complement A = M⁻¹ - M⁻¹Sᵀ(S M⁻¹Sᵀ)⁻¹S M⁻¹.</summary>
public unsafe class TreeMassTests
{
    /// <summary>What a dense inverse of some 40 rows at mass ratios to 1:1000 leaves of 16 digits.</summary>
    private const double Rounding = 1e-7;

    /// <summary>With two anchors the far one's block is singular and gets 1e-9 of its own response, at ratios to 1:1000.</summary>
    private const double Regular = 1e-5;

    [Theory]
    [InlineData(2, 0)]
    [InlineData(3, 1)]
    [InlineData(9, 0)]
    [InlineData(12, 1)]
    [InlineData(12, 2)]
    public void FullMass_IsTheDenseSchurComplement(int bodies, int anchors)
    {
        double* between = stackalloc double[9];
        for (int seed = 0; seed < 20; seed++)
        {
            var tree = new RandomTree(seed, bodies, anchors);
            for (int a = 1; a <= bodies; a++)
            {
                for (int b = 1; b <= bodies; b++)
                {
                    TreeCross.Write(tree.Forest.Nodes, tree.Forest.NodeOf(a), tree.Forest.NodeOf(b), between);
                    for (int k = 0; k < 9; k++)
                    {
                        double exact = tree.Dense[((a - 1) * 3) + (k / 3), ((b - 1) * 3) + (k % 3)];
                        Assert.InRange(Math.Abs(between[k] - exact), 0, tree.Tolerance * tree.Largest);
                    }
                }
            }
        }
    }

    [Theory]
    [InlineData(7, 0)]
    [InlineData(12, 1)]
    [InlineData(12, 2)]
    public void LazyWalk_IsTheDenseProduct(int bodies, int anchors)
    {
        for (int seed = 0; seed < 20; seed++)
        {
            var tree = new RandomTree(seed, bodies, anchors);
            double[] expected = tree.RandomVelocities();
            JointForestView view = tree.Forest.View;
            TreeWalk.Begin(view, tree.Forest.Trees);
            var random = new Random(seed);
            for (int i = 0; i < 30; i++)
            {
                int body = 1 + random.Next(bodies);
                double[] p = { random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5 };
                int node = tree.Forest.NodeOf(body);
                TreeWalk.Visit(view, node);
                for (int k = 0; k < expected.Length; k++)
                {
                    for (int c = 0; c < 3; c++)
                    {
                        expected[k] += tree.Dense[k, ((body - 1) * 3) + c] * p[c];
                    }
                }

                // The body that is visited has its velocity right at once, before the others have.
                TreeWalk.Apply(view, node, p[0], p[1], p[2]);
                for (int c = 0; c < 3; c++)
                {
                    Assert.Equal(expected[((body - 1) * 3) + c], tree.Forest.Nodes[node].Velocity[c], tree.Tolerance * tree.Largest * 30);
                }
            }

            TreeWalk.End(view, tree.Forest.Trees);
            tree.AssertVelocities(expected, tree.Tolerance * tree.Largest * 30);
        }
    }

    [Theory]
    [InlineData(7, 0)]
    [InlineData(12, 1)]
    [InlineData(12, 2)]
    public void Solution_IsTheNearestVelocityThatMeetsTheJoints_AndItsImpulsesMakeIt(int bodies, int anchors)
    {
        for (int seed = 0; seed < 20; seed++)
        {
            var tree = new RandomTree(seed, bodies, anchors);
            double[] before = tree.RandomVelocities();
            TreeSolve.Run(tree.Forest, tree.Forest.Trees);
            TreeReactions.OfSolve(tree.Forest, tree.Forest.Trees);
            TreeReactions.Give(tree.Forest, tree.Forest.Trees, tree.Active.Pointer, tree.Rows.Pointer);

            // Targets of 0: v = A·M·v.
            var expected = new double[before.Length];
            for (int i = 0; i < expected.Length; i++)
            {
                for (int k = 0; k < before.Length; k++)
                {
                    expected[i] += tree.Dense[i, k] / tree.InverseMass[k] * before[k];
                }
            }

            // Masses up to 1,000 multiply what the dense inverse has lost.
            tree.AssertVelocities(expected, 1e3 * tree.Tolerance);
            tree.AssertImpulses(before, 1e3 * tree.Tolerance);
        }
    }

    /// <summary>Bodies at random places with masses from 1 to 1,000, hinged to a random earlier one; some also to the world.</summary>
    private sealed class RandomTree
    {
        private readonly Column<BodyMass> _masses = new Column<BodyMass>();
        private readonly Column<byte> _moves = new Column<byte>();
        private readonly int _bodies;
        private readonly Random _random;

        public RandomTree(int seed, int bodies, int anchors)
        {
            _random = new Random(seed);
            _bodies = bodies;
            Tolerance = anchors > 1 ? Regular : Rounding;
            int joints = bodies - 1 + anchors;
            Active.EnsureCapacity(joints);
            Rows.EnsureCapacity(joints);
            _masses.EnsureCapacity(bodies + 1);
            _moves.EnsureCapacity(bodies + 1);
            InverseMass = new double[3 * bodies];
            var places = new double[(2 * bodies) + 2];
            for (int i = 1; i <= bodies; i++)
            {
                double mass = Math.Pow(10, 3 * _random.NextDouble());
                _masses[i] = new BodyMass { Mass = (float)mass, InverseMass = (float)(1 / mass), InverseInertia = (float)(6 / mass) };
                _moves[i] = 1;
                InverseMass[(3 * i) - 3] = _masses[i].InverseMass;
                InverseMass[(3 * i) - 2] = _masses[i].InverseMass;
                InverseMass[(3 * i) - 1] = _masses[i].InverseInertia;
                places[2 * i] = 4 * _random.NextDouble();
                places[(2 * i) + 1] = 4 * _random.NextDouble();
            }

            for (int i = 0; i < joints; i++)
            {
                int child = i < bodies - 1 ? i + 2 : i == bodies - 1 ? 1 : bodies;

                // Between two anchors a chain: fewer links than that would be a rigid frame.
                int parent = i >= bodies - 1 ? 0 : anchors > 1 ? i + 1 : 1 + _random.Next(i + 1);
                double x = places[2 * child] + _random.NextDouble() - 0.5;
                double y = places[(2 * child) + 1] + _random.NextDouble() - 0.5;
                JointFrame frame = default;
                frame.RAX = x - places[2 * parent];
                frame.RAY = y - places[(2 * parent) + 1];
                frame.RBX = x - places[2 * child];
                frame.RBY = y - places[(2 * child) + 1];
                Rows[i] = default;
                Rows[i].AddPoint(RowType.Hard, frame);
                Active[i] = default;
                Active[i].Ends.BodyA = parent;
                Active[i].Ends.BodyB = child;
                Active[i].BuiltHard = 2;
            }

            Forest.Build(Active.Pointer, joints, _masses.Pointer, _moves.Pointer, new NetSearch(), bodies + 1);
            Assert.Equal(1, Forest.TreeCount);
            for (int i = 0; i < Forest.Count; i++)
            {
                TreeNode* node = Forest.Nodes + i;
                Assert.True(node->Parent < i);
                node->InverseMass = _masses[node->Body].InverseMass;
                node->InverseInertia = _masses[node->Body].InverseInertia;
            }

            TreeFactor.Run(Forest, Forest.Trees, Active.Pointer, Rows.Pointer);
            TreeFactor.CompleteMasses(Forest, Forest.Trees);
            Joints = joints;
            Eliminate();
        }

        public JointForest Forest { get; } = new JointForest();

        public Column<ActiveJoint> Active { get; } = new Column<ActiveJoint>();

        public Column<JointRows> Rows { get; } = new Column<JointRows>();

        public double[] InverseMass { get; }

        public double[,] Dense { get; private set; } = new double[0, 0];

        public double Largest { get; private set; }

        public double Tolerance { get; }

        private int Joints { get; }

        public double[] RandomVelocities()
        {
            var all = new double[3 * _bodies];
            for (int i = 0; i < all.Length; i++)
            {
                all[i] = _random.NextDouble() - 0.5;
                Forest.Nodes[Forest.NodeOf(1 + (i / 3))].Velocity[i % 3] = all[i];
            }

            return all;
        }

        public void AssertVelocities(double[] expected, double tolerance)
        {
            for (int i = 0; i < expected.Length; i++)
            {
                Assert.Equal(expected[i], Forest.Nodes[Forest.NodeOf(1 + (i / 3))].Velocity[i % 3], tolerance);
            }
        }

        /// <summary>The impulses of the joints, applied to the bodies' own masses, make the change of velocity.</summary>
        public void AssertImpulses(double[] before, double tolerance)
        {
            var made = (double[])before.Clone();
            for (int i = 0; i < Joints; i++)
            {
                ref ActiveJoint joint = ref Active[i];
                JointRows* rows = Rows.Pointer + i;
                double* given = Active.Pointer[i].Given;

                // Both rows of a hinge have unit forces: the impulse itself is what body B got, and A gets the opposite at its arm.
                for (int c = 0; c < 3; c++)
                {
                    int b = (3 * (joint.Ends.BodyB - 1)) + c;
                    made[b] += InverseMass[b] * given[c];
                    if (joint.Ends.BodyA > 0)
                    {
                        int a = (3 * (joint.Ends.BodyA - 1)) + c;
                        made[a] += InverseMass[a] * ((rows->A[c] * given[0]) + (rows->A[3 + c] * given[1]));
                    }
                }
            }

            AssertVelocities(made, tolerance);
        }

        private void Eliminate()
        {
            int size = 3 * _bodies;
            int count = 2 * Joints;
            var s = new double[count, size];
            for (int i = 0; i < Joints; i++)
            {
                JointRows* rows = Rows.Pointer + i;
                for (int k = 0; k < 6; k++)
                {
                    int row = (2 * i) + (k / 3);
                    s[row, (3 * (Active[i].Ends.BodyB - 1)) + (k % 3)] = rows->B[k];
                    if (Active[i].Ends.BodyA > 0)
                    {
                        s[row, (3 * (Active[i].Ends.BodyA - 1)) + (k % 3)] = rows->A[k];
                    }
                }
            }

            // Row by row: A - A sᵀ(s A sᵀ)⁻¹ s A.
            Dense = new double[size, size];
            for (int i = 0; i < size; i++)
            {
                Dense[i, i] = InverseMass[i];
                Largest = Math.Max(Largest, InverseMass[i]);
            }

            for (int row = 0; row < count; row++)
            {
                var product = new double[size];
                double response = 0;
                for (int i = 0; i < size; i++)
                {
                    for (int k = 0; k < size; k++)
                    {
                        product[i] += Dense[i, k] * s[row, k];
                    }
                }

                for (int i = 0; i < size; i++)
                {
                    response += s[row, i] * product[i];
                }

                for (int i = 0; i < size; i++)
                {
                    for (int k = 0; k < size; k++)
                    {
                        Dense[i, k] -= product[i] * product[k] / response;
                    }
                }
            }
        }
    }
}
